% SPDX-License-Identifier: Apache-2.0
% Heun's method for the dissipative stochastic rigid body: polhode verify SCENE --with 'octave-cli -q my_heun.m'
1;
function out = cross_of(a, b)
  out = [a(:,2) .* b(:,3) - a(:,3) .* b(:,2), a(:,3) .* b(:,1) - a(:,1) .* b(:,3), a(:,1) .* b(:,2) - a(:,2) .* b(:,1)];
end
function out = increment(pi, scene, dt, noise)  % Pi x ((Omega + theta Pi x Omega) dt + sum sigma_i dW^i), a path a row
  omega = pi ./ scene.inertia';
  out = cross_of(pi, (omega + scene.theta * cross_of(pi, omega)) * dt + noise);
end
function answer(header, dt, data)
  header(6) = numel(data);
  fwrite(stdout, [typecast(int32(header'), 'uint8'), typecast(dt, 'uint8'), data]);
  fflush(stdout);
end

puts(['{"polhode":1,"name":"my_heun","title":"Heun''s method in Octave","claims":{"strong_commuting":1,"strong_general":0.5,', ...
      '"weak_one_vector":1,"weak_isotropic":1,"weak_general":1,"deterministic":2,"casimir":1,"casimir_deterministic":3}}', "\n"]);
fflush(stdout);
while numel(header = fread(stdin, 6, 'int32')) == 6
  dt = fread(stdin, 1, 'double');
  if header(2) == 1
    scene = jsondecode(fread(stdin, header(6), 'char=>char')');
    if strcmp(scene.system, 'rigid_body'), why = ''; else, why = 'my_heun knows rigid bodies alone'; end
    answer(header, dt, uint8(why));
    continue
  end
  paths = header(3); steps = header(4);
  numbers = reshape(fread(stdin, header(6) / 8, 'double'), paths, []);
  pi = numbers(:, 1:3);
  dw = reshape(numbers(:, 4:end), paths, [], steps);
  for i = 1:steps
    if header(5) == 0, noise = 0; else, noise = dw(:, :, i) * scene.sigma; end
    first = increment(pi, scene, dt, noise);
    pi = pi + (first + increment(pi + first, scene, dt, noise)) / 2;
  end
  answer(header, dt, typecast(pi(:)', 'uint8'));
end
