#!/usr/bin/env bash
# Meshes that `fumon export` writes before Khronos' glTF validator, which FUMON_GLTF names: a folder whose node_modules holds
# gltf-validator. Without it this says so and ends with status 77, which CTest counts as skipped.
#
#     tests/reach/gltf.sh build/release/fumon assets/terrain/west_bijou_gully.asc
set -euo pipefail
FUMON=$(realpath "$1") TERRAIN=$(realpath "$2")
[ -d "${FUMON_GLTF:-}/node_modules/gltf-validator" ] && command -v node > /dev/null ||
    { echo "skipped: the glTF validator (FUMON_GLTF, node) is not there"; exit 77; }
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
cd "$place"
"$FUMON" run terada-ripples -o run -q --set grid.nx=24 --set grid.ny=16 --set run.steps=4 --set output.frames=false \
    --set output.movie=false --set output.fields_every=4
"$FUMON" export run -o sites.glb -q
"$FUMON" export "$TERRAIN" -o terrain.glb -q
cat > judge.js <<'JS'
"use strict";
const validator = require("gltf-validator");
const bytes = new Uint8Array(require("fs").readFileSync(process.argv[2]));
validator.validateBytes(bytes).then(report => {
  const { numErrors, numWarnings, messages } = report.issues;
  console.log(`${process.argv[2]}: ${numErrors} errors, ${numWarnings} warnings, ${report.info.totalVertexCount} points`);
  if (numErrors + numWarnings > 0) { console.log(messages); process.exit(1); }
});
JS
for mesh in sites.glb terrain.glb; do NODE_PATH="$FUMON_GLTF/node_modules" node judge.js "$mesh"; done
