// SPDX-License-Identifier: Apache-2.0
// The globe: one square, and a fragment shader that meets the sphere at each pixel.
import type { Density } from '../data';
import { coloured, type Scale } from './colours';
import { frameOf, type View } from './sphere';

const vertex = `#version 300 es
out vec2 at;
void main() {
  at = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  gl_Position = vec4(at, 0.0, 1.0);
}`;

const fragment = `#version 300 es
precision highp float;
uniform sampler2D density;
uniform mat3 frame;   // columns: right, up, towards the viewer
uniform float pixel;  // of the disc's radius
in vec2 at;
out vec4 colour;
const float pi = 3.14159265358979;

float line(float x, float every) {  // 1 on a line of the graticule
  float away = abs(fract(x / every + 0.5) - 0.5) * every;
  return 1.0 - smoothstep(0.5, 1.5, away / max(fwidth(x), 1e-6));
}

void main() {
  vec2 p = at * 1.04;
  float r = length(p);
  if (r > 1.0) {
    colour = vec4(0.0);
    if (r > 1.0 + 2.0 * pixel) discard;
  }
  vec3 n = frame * vec3(p, sqrt(max(0.0, 1.0 - r * r)));
  float longitude = atan(n.y, n.x), latitude = asin(clamp(n.z, -1.0, 1.0));
  vec3 c = textureLod(density, vec2(longitude / (2.0 * pi) + 0.5, 0.5 * n.z + 0.5), 0.0).rgb;
  float seam = step(fwidth(longitude), 1.0);
  float net = max(line(longitude, pi / 6.0) * seam * step(abs(n.z), 0.985), line(latitude, pi / 6.0));
  c = mix(c, vec3(1.0), 0.22 * net);
  float edge = 1.0 - smoothstep(1.0 - pixel, 1.0 + pixel, r);
  colour = vec4(c * edge, edge);
}`;

export class Globe {
  private constructor(
    private readonly gl: WebGL2RenderingContext,
    private readonly program: WebGLProgram,
  ) {}

  /** Null where there is no WebGL2. */
  static on(canvas: HTMLCanvasElement): Globe | null {
    const gl = canvas.getContext('webgl2', {
      alpha: true,
      antialias: true,
      premultipliedAlpha: true,
      preserveDrawingBuffer: true,
    });
    const program = gl?.createProgram();
    if (!gl || !program) return null;
    for (const [kind, source] of [
      [gl.VERTEX_SHADER, vertex],
      [gl.FRAGMENT_SHADER, fragment],
    ] as const) {
      const shader = gl.createShader(kind);
      if (!shader) return null;
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) return null;
    gl.useProgram(program);
    gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.LINEAR);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.REPEAT);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
    return new Globe(gl, program);
  }

  load(d: Density, scale: Scale): void {
    const { gl } = this,
      pixels = new Uint8Array(coloured(d, scale).buffer);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, d.longitudes, d.heights, 0, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  }

  draw(view: View): void {
    const { gl, program } = this,
      { width, height } = gl.canvas;
    gl.viewport(0, 0, width, height);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT);
    gl.uniformMatrix3fv(gl.getUniformLocation(program, 'frame'), false, frameOf(view).flat());
    gl.uniform1f(gl.getUniformLocation(program, 'pixel'), 2.08 / width);
    gl.drawArrays(gl.TRIANGLE_STRIP, 0, 4);
  }
}
