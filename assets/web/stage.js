// The picture: the surface with fumon's colours over it, and the upright sides of the block.
const canvas = document.getElementById("canvas");
let gl = null;
let programs = null;
let meshes = null;
const textures = {};

const surfaceCode = `#version 300 es
precision highp float;
precision highp sampler2D;
uniform mat4 clip;
uniform sampler2D surface;
uniform vec2 extent;
in vec2 node;
out vec2 place;
void main() {
  ivec2 cells = textureSize(surface, 0);
  place = clamp((node - 0.5) / vec2(cells), 0.0, 1.0);
  float z = texelFetch(surface, clamp(ivec2(node) - 1, ivec2(0), cells - 1), 0).r;
  gl_Position = clip * vec4((place - 0.5) * extent, z, 1.0);
}`;
const colourCode = `#version 300 es
precision highp float;
uniform sampler2D picture;
in vec2 place;
out vec4 colour;
void main() { colour = vec4(texture(picture, vec2(place.x, 1.0 - place.y)).rgb, 1.0); }`;
const wallCode = `#version 300 es
precision highp float;
precision highp sampler2D;
uniform mat4 clip;
uniform sampler2D ground;
uniform sampler2D surface;
uniform vec2 extent;
uniform float base;
uniform vec3 walls[16];
in vec4 corner;
flat out vec3 shade;
void main() {
  ivec2 cells = textureSize(surface, 0);
  ivec2 cell = clamp(ivec2(corner.xy) - 1, ivec2(0), cells - 1);
  vec2 place = clamp((corner.xy - 0.5) / vec2(cells), 0.0, 1.0);
  float low = texelFetch(ground, cell, 0).r;
  float z = corner.z == 0.0 ? base : corner.z == 1.0 ? low : texelFetch(surface, cell, 0).r;
  shade = walls[int(corner.w)];
  gl_Position = clip * vec4((place - 0.5) * extent, z, 1.0);
}`;
const plainCode = `#version 300 es
precision highp float;
flat in vec3 shade;
out vec4 colour;
void main() { colour = vec4(shade, 1.0); }`;

function program(vertex, fragment) {
  const made = gl.createProgram();
  for (const [kind, code] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, code);
    gl.compileShader(shader);
    gl.attachShader(made, shader);
  }
  gl.bindAttribLocation(made, 0, "node");
  gl.bindAttribLocation(made, 0, "corner");
  gl.linkProgram(made);
  if (!gl.getProgramParameter(made, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(made) ?? "");
  const places = {};
  for (const name of ["clip", "surface", "ground", "picture", "extent", "base", "walls"]) places[name] = gl.getUniformLocation(made, name);
  return { made, places };
}

/** Nodes are the middles of cells, and the edges of the block around them: whether one has data. */
function nodeTest() {
  const clamped = (at, count) => Math.min(Math.max(at - 1, 0), count - 1);
  return (i, j) => i >= 0 && j >= 0 && i < columns + 2 && j < rows + 2 && hasData(clamped(j, rows) * columns + clamped(i, columns));
}

/** The triangles of a square of nodes: two of four with data, one of three. Counter-clockwise, from above. */
function trianglesOf(known, i, j) {
  const round = [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]].filter(([x, y]) => known(x, y));
  if (round.length < 3) return [];
  return round.length === 3 ? [round] : [[round[0], round[1], round[2]], [round[0], round[2], round[3]]];
}

/** The way that a wall faces whose surface lies left of an edge: 0 east, 1 north, 2 west, 3 south, then between these. */
function facing([x0, y0], [x1, y1]) {
  const [east, north] = [Math.sign(y1 - y0), Math.sign(x0 - x1)];
  if (north === 0) return east > 0 ? 0 : 2;
  if (east === 0) return north > 0 ? 1 : 3;
  return east > 0 ? (north > 0 ? 4 : 7) : north > 0 ? 5 : 6;
}

function mesh(values, size, indices) {
  const array = gl.createVertexArray();
  gl.bindVertexArray(array);
  gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
  gl.bufferData(gl.ARRAY_BUFFER, values, gl.STATIC_DRAW);
  gl.enableVertexAttribArray(0);
  gl.vertexAttribPointer(0, size, gl.UNSIGNED_SHORT, false, 0, 0);
  gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
  gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, indices, gl.STATIC_DRAW);
  return { array, count: indices.length };
}

function makeMeshes() {
  const known = nodeTest();
  const wide = columns + 2;
  const number = ([i, j]) => j * wide + i;
  const nodes = new Uint16Array(2 * wide * (rows + 2));
  for (let j = 0, at = 0; j < rows + 2; ++j) for (let i = 0; i < wide; ++i) { nodes[at++] = i; nodes[at++] = j; }
  const triangles = [];
  const open = new Map();  // edges that no other triangle runs along
  const edge = (from, to) => {
    const back = number(to) * wide * (rows + 2) + number(from);
    if (!open.delete(back)) open.set(number(from) * wide * (rows + 2) + number(to), [from, to]);
  };
  for (let j = 0; j <= rows; ++j) {
    for (let i = 0; i <= columns; ++i) {
      for (const [a, b, c] of trianglesOf(known, i, j)) {
        triangles.push(number(a), number(b), number(c));
        edge(a, b);
        edge(b, c);
        edge(c, a);
      }
    }
  }
  const corners = [];
  const walls = [];
  for (const [from, to] of open.values()) {
    for (const low of [0, 1]) {  // ground, and water over it
      const first = corners.length / 4;
      const kind = facing(from, to) + 8 * low;
      for (const [node, level] of [[from, low], [to, low], [to, low + 1], [from, low + 1]]) corners.push(...node, level, kind);
      walls.push(first, first + 1, first + 2, first, first + 2, first + 3);
    }
  }
  meshes = { top: mesh(nodes, 2, new Uint32Array(triangles)), walls: mesh(new Uint16Array(corners), 4, new Uint32Array(walls)) };
}

/** Of a block's four sides, and of those between them. */
function sidesOf(colours) {
  const between = [[0, 1], [2, 1], [2, 3], [0, 3]].map(([a, b]) => colours[a].map((level, k) => (level + colours[b][k]) / 2));
  return [...colours, ...between].flat().map((level) => level / 255);
}

function texture(name) {
  textures[name] ??= gl.createTexture();
  gl.activeTexture(gl.TEXTURE0);
  gl.bindTexture(gl.TEXTURE_2D, textures[name]);
  for (const key of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, key, gl.CLAMP_TO_EDGE);
}

function setField(name, values) {
  texture(name);
  for (const key of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, key, gl.NEAREST);
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.R32F, columns, rows, 0, gl.RED, gl.FLOAT, values);
}

function setPicture(bitmap) {
  texture("picture");
  gl.pixelStorei(gl.UNPACK_COLORSPACE_CONVERSION_WEBGL, gl.NONE);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR_MIPMAP_LINEAR);
  const finer = gl.getExtension("EXT_texture_filter_anisotropic");
  if (finer) gl.texParameterf(gl.TEXTURE_2D, finer.TEXTURE_MAX_ANISOTROPY_EXT, 8);
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, gl.RGBA, gl.UNSIGNED_BYTE, bitmap);
  gl.generateMipmap(gl.TEXTURE_2D);
}

/** What lasts from bed to bed; once more where the browser took it away. */
function prepareDrawing() {
  for (const name of Object.keys(textures)) delete textures[name];
  programs = { top: program(surfaceCode, colourCode), walls: program(wallCode, plainCode) };
  makeMeshes();
  gl.enable(gl.DEPTH_TEST);
}

/** Throws why this browser does not draw; `again` is called when it has taken the picture away and draws once more. */
function startDrawing(again) {
  gl = canvas.getContext("webgl2", { antialias: true, alpha: true });
  if (!gl) throw new Error("no WebGL 2");
  const most = gl.getParameter(gl.MAX_TEXTURE_SIZE);
  if (Math.max(columns, rows) > most) throw new Error(`${Math.max(columns, rows)} points in a row, it draws ${most}`);
  prepareDrawing();
  canvas.addEventListener("webglcontextlost", (event) => event.preventDefault());
  canvas.addEventListener("webglcontextrestored", () => { prepareDrawing(); again(); });
}

function showBed(surfaces, bitmap) {
  setField("ground", surfaces.ground);
  setField("surface", surfaces.surface);
  setPicture(bitmap);
}

function use({ made, places }, clip) {
  gl.useProgram(made);
  gl.uniformMatrix4fv(places.clip, false, clip);
  gl.uniform2fv(places.extent, run.extent);
  ["surface", "ground", "picture"].forEach((name, unit) => {
    gl.activeTexture(gl.TEXTURE0 + unit);
    gl.bindTexture(gl.TEXTURE_2D, textures[name]);
    if (places[name]) gl.uniform1i(places[name], unit);
  });
}

function drawStage() {
  const dots = Math.min(window.devicePixelRatio || 1, 2);
  const [width, height] = [Math.max(1, Math.round(canvas.clientWidth * dots)), Math.max(1, Math.round(canvas.clientHeight * dots))];
  if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
  const clip = clipMatrix(width / height);
  gl.viewport(0, 0, width, height);
  gl.clearColor(0, 0, 0, 0);
  gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
  use(programs.top, clip);
  gl.bindVertexArray(meshes.top.array);
  gl.drawElements(gl.TRIANGLES, meshes.top.count, gl.UNSIGNED_INT, 0);
  use(programs.walls, clip);
  gl.uniform1f(programs.walls.places.base, run.base);
  gl.uniform3fv(programs.walls.places.walls, [...sidesOf(run.walls), ...sidesOf(run.water)]);
  gl.bindVertexArray(meshes.walls.array);
  gl.drawElements(gl.TRIANGLES, meshes.walls.count, gl.UNSIGNED_INT, 0);
}
