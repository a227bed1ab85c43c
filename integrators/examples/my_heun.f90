! SPDX-License-Identifier: Apache-2.0
! Heun's method for the dissipative stochastic rigid body in Fortran, for `polhode verify SCENE --with ./my_heun.so`:
!   gfortran -O2 -shared -fPIC my_heun.f90 -o my_heun.so
! The types repeat <polhode/abi.h> member by member.
module my_heun
  use, intrinsic :: iso_c_binding
  implicit none

  type, bind(c) :: polhode_scene
    integer(c_int32_t) :: size, components, channels
    real(c_double) :: dt, theta
    type(c_ptr) :: name, system, momentum, sigma
    type(c_funptr) :: parameter
    type(c_ptr) :: json
  end type
  type, bind(c) :: polhode_batch
    integer(c_int32_t) :: size, paths, steps
    type(c_ptr) :: states, dw, area, seed, time, variables
  end type
  type, bind(c) :: polhode_claims
    real(c_double) :: strong_commuting, strong_general, weak_one_vector, weak_isotropic, weak_general, deterministic, &
                      casimir, casimir_deterministic
  end type
  type, bind(c) :: polhode_integrator
    integer(c_int32_t) :: size, takes, flags
    type(c_ptr) :: name, title, source
    type(polhode_claims) :: claims
    type(c_funptr) :: open, advance, close
    type(c_ptr) :: draws
    integer(c_int32_t) :: drawn
  end type
  abstract interface
    function parameter_of(scene, key, rows, columns) bind(c) result(values)
      import
      type(polhode_scene), intent(in) :: scene
      character(kind=c_char), intent(in) :: key(*)
      integer(c_int32_t) :: rows, columns
      type(c_ptr) :: values
    end function
  end interface

  type body
    real(c_double) :: inertia(3), theta, dt
    real(c_double), allocatable :: sigma(:, :)
  end type
  type(polhode_integrator), target :: mine
  character(kind=c_char, len=8), target :: name = 'f_heun' // c_null_char

contains

  pure function cross(a, b) result(c)
    real(c_double), intent(in) :: a(3), b(3)
    real(c_double) :: c(3)
    c = [a(2) * b(3) - a(3) * b(2), a(3) * b(1) - a(1) * b(3), a(1) * b(2) - a(2) * b(1)]
  end function

  ! Pi x (Omega + theta Pi x Omega) dt + Pi x sum sigma_i dW^i
  pure function slope(b, pi, noise) result(out)
    type(body), intent(in) :: b
    real(c_double), intent(in) :: pi(3), noise(3)
    real(c_double) :: out(3)
    out = cross(pi, (pi / b%inertia + b%theta * cross(pi, pi / b%inertia)) * b%dt + noise)
  end function

  function open_body(scene, self, why, bytes) bind(c, name='my_heun_open') result(code)
    type(polhode_scene), intent(in) :: scene
    type(c_ptr), intent(out) :: self
    character(kind=c_char) :: why(*)
    integer(c_size_t), value :: bytes
    integer(c_int) :: code
    procedure(parameter_of), pointer :: parameter
    type(body), pointer :: b
    real(c_double), pointer :: values(:), sigma(:, :)
    type(c_ptr) :: inertia
    integer(c_int32_t) :: rows, columns
    call c_f_procpointer(scene%parameter, parameter)
    inertia = parameter(scene, 'inertia' // c_null_char, rows, columns)
    why(1:min(bytes, 1_c_size_t)) = c_null_char
    code = 1
    if (scene%components /= 3 .or. .not. c_associated(inertia)) return
    allocate (b)
    call c_f_pointer(inertia, values, [3])
    call c_f_pointer(scene%sigma, sigma, [3, int(scene%channels)])
    b%inertia = values
    b%sigma = sigma
    b%theta = scene%theta
    b%dt = scene%dt
    self = c_loc(b)
    code = 0
  end function

  function advance(self, batch) bind(c, name='my_heun_advance') result(code)
    type(c_ptr), value :: self
    type(polhode_batch), intent(in) :: batch
    integer(c_int) :: code
    type(body), pointer :: b
    real(c_double), pointer :: states(:, :), dw(:, :, :)
    real(c_double) :: pi(3), noise(3), first(3)
    integer :: i, p
    call c_f_pointer(self, b)
    call c_f_pointer(batch%states, states, [int(batch%paths), 3])
    if (c_associated(batch%dw)) call c_f_pointer(batch%dw, dw, [int(batch%paths), size(b%sigma, 2), int(batch%steps)])
    do i = 1, batch%steps
      do p = 1, batch%paths
        pi = states(p, :)
        noise = 0
        if (c_associated(batch%dw)) noise = matmul(b%sigma, dw(p, :, i))
        first = slope(b, pi, noise)
        states(p, :) = pi + (first + slope(b, pi + first, noise)) / 2
      end do
    end do
    code = 0
  end function

  subroutine close_body(self) bind(c, name='my_heun_close')
    type(c_ptr), value :: self
    type(body), pointer :: b
    call c_f_pointer(self, b)
    deallocate (b)
  end subroutine

  function polhode_integrators(abi_version, count) bind(c) result(all)
    integer(c_int32_t), value :: abi_version
    integer(c_int32_t), intent(out) :: count
    type(c_ptr) :: all
    count = 1
    all = c_null_ptr
    if (abi_version /= 1) return
    mine%size = int(c_sizeof(mine), c_int32_t)
    mine%takes = 0
    mine%flags = 0
    mine%name = c_loc(name)
    mine%title = c_null_ptr
    mine%source = c_null_ptr
    mine%claims = polhode_claims(1d0, 0.5d0, 1d0, 1d0, 1d0, 2d0, 1d0, 3d0)
    mine%open = c_funloc(open_body)
    mine%advance = c_funloc(advance)
    mine%close = c_funloc(close_body)
    mine%draws = c_null_ptr
    mine%drawn = 0
    all = c_loc(mine)
  end function
end module
