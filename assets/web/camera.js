// The camera around the block: azimuth and elevation in degrees, where it looks, and how far away it stands.
const pose = { azimuth: 0, elevation: 0, distance: 1, target: [0, 0, 0] };
const radians = Math.PI / 180;
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const along = (a, b, k) => a.map((x, i) => x + k * b[i]);

function axes() {
  const [sa, ca] = [Math.sin(pose.azimuth * radians), Math.cos(pose.azimuth * radians)];
  const [se, ce] = [Math.sin(pose.elevation * radians), Math.cos(pose.elevation * radians)];
  const ahead = [-sa * ce, -ca * ce, -se];
  const right = [-ca, sa, 0];
  return { ahead, right, up: [-sa * se, -ca * se, ce] };
}

const eyeOf = ({ ahead }) => along(pose.target, ahead, -pose.distance);

/** As near as the margin allows, as fumon fits a block: on each axis the corners bound two lines, which cross at the eye. */
function fitPose(aspect) {
  Object.assign(pose, { azimuth: run.azimuth, elevation: run.elevation });
  const { ahead, right, up } = axes();
  const usable = 1 - 2 * run.margin;
  const half = [run.tangent * aspect * usable, run.tangent * usable];
  const eye = [0, 0];
  let depth = Infinity;
  [right, up].forEach((axis, i) => {
    let most = -Infinity;
    let least = Infinity;
    for (const [x, y] of run.outline) {
      for (const z of [run.base, run.top]) {
        const far = half[i] * dot([x, y, z], ahead);
        const across = dot([x, y, z], axis);
        most = Math.max(most, across - far);
        least = Math.min(least, across + far);
      }
    }
    depth = Math.min(depth, (least - most) / (2 * half[i]));
    eye[i] = (least + most) / 2;
  });
  const at = along(along(along([0, 0, 0], right, eye[0]), up, eye[1]), ahead, depth);
  pose.distance = Math.max(-depth, 0.05);
  pose.target = along(at, ahead, pose.distance);
}

function turnBy(right, up) {
  pose.azimuth = (((pose.azimuth + right) % 360) + 360) % 360;
  pose.elevation = Math.min(89.9, Math.max(1, pose.elevation + up));
}

/** In heights of the picture. */
function panBy(right, up) {
  const seen = axes();
  const scale = 2 * run.tangent * pose.distance;
  const reach = (x) => Math.min(1.5, Math.max(-1.5, x));
  pose.target = along(along(pose.target, seen.right, right * scale), seen.up, up * scale).map(reach);
}

function dollyBy(factor) {
  pose.distance = Math.min(20, Math.max(0.03, pose.distance * factor));
}

/** From the block to the picture, −1 … 1, columns after one another. */
function clipMatrix(aspect) {
  const seen = axes();
  const eye = eyeOf(seen);
  const near = Math.max(pose.distance * 0.02, 0.002);
  const far = pose.distance + 4;
  const { right, up, ahead } = seen;
  const x = 1 / (run.tangent * aspect);
  const y = 1 / run.tangent;
  const a = (far + near) / (far - near);
  const b = (-2 * far * near) / (far - near);
  const matrix = new Float32Array(16);
  for (let i = 0; i < 3; ++i) matrix.set([right[i] * x, up[i] * y, ahead[i] * a, ahead[i]], 4 * i);
  matrix.set([-dot(eye, right) * x, -dot(eye, up) * y, -dot(eye, ahead) * a + b, -dot(eye, ahead)], 12);
  return matrix;
}

/** The ray through a place of the picture, −1 … 1 rightward and upward. */
function rayThrough(x, y, aspect) {
  const seen = axes();
  const way = along(along(seen.ahead, seen.right, x * run.tangent * aspect), seen.up, y * run.tangent);
  return { from: eyeOf(seen), way };
}
