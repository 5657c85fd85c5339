#!/usr/bin/env bash
# Builds the package and the page and tests both: bash examples/web/test.sh
set -euo pipefail
cd "$(dirname "$0")"

command -v node >/dev/null || { echo "SKIPPED  the web package: node is not installed"; exit 0; }
rustup target list --installed | grep -qx wasm32-unknown-unknown || rustup target add wasm32-unknown-unknown ||
    { echo "SKIPPED  the web package: target wasm32-unknown-unknown cannot be installed"; exit 0; }

for feature in core light paint scene cost bands bench lists; do
    cargo clippy --quiet --no-default-features --features "$feature" -- -D warnings
done
node tools/build.mjs --bench
[[ -x node_modules/.bin/tsc ]] ||
    echo "SKIPPED  the sizes of packed modules and page, and the types: npm ci cannot install esbuild, binaryen and typescript"
node --test test/package.test.mjs test/sizes.test.mjs test/installed.test.mjs

if ! command -v "${CHROMIUM:-chromium}" >/dev/null; then
    sudo=
    [[ $(id -u) == 0 ]] || sudo=sudo
    { $sudo apt-get update && $sudo apt-get install -y --no-install-recommends chromium fonts-dejavu-core; } ||
        { echo "SKIPPED  the page: chromium cannot be installed"; exit 0; }
fi
node --test test/page.test.mjs
