#!/usr/bin/env bash
# Everything that guards a promise, in one command; needs rustup, and installs the rest.
#
#   bash tests/all.sh
#
# Emulators and targets that cannot be installed are reported as SKIPPED in plain words.
set -euo pipefail
cd "$(dirname "$0")/.."
export CARGO_TERM_COLOR=${CARGO_TERM_COLOR:-never}
# The same random cases every time: a failure is the commit's. Another seed looks elsewhere.
export PROPTEST_RNG_SEED=${PROPTEST_RNG_SEED:-1}
# Nobody steps through these builds: a quarter less to compile.
export CARGO_PROFILE_DEV_DEBUG=0

step() { printf '\n== %s (after %d s)\n' "$*" "$SECONDS"; }

bare="thumbv6m-none-eabi thumbv7em-none-eabihf thumbv8m.main-none-eabihf riscv32imac-unknown-none-elf wasm32-unknown-unknown"
skipped=()

step "targets, formatter, lints and valgrind"
for target in $bare; do
    rustup target add "$target" || skipped+=("target $target cannot be installed: nothing was built for it")
done
rustup component add rustfmt clippy
if ! command -v valgrind >/dev/null; then
    sudo=
    [[ $(id -u) == 0 ]] || sudo=sudo
    $sudo apt-get update && $sudo apt-get install -y --no-install-recommends valgrind ||
        skipped+=("valgrind cannot be installed: no instructions of paths were counted on the host")
fi

# What other targets need: beside the tests, since both leave a core idle now and then.
other_targets() {
    # (The default is what the crates for devices and for the web are built with.)
    step "other targets: each feature alone, none and all, on a host; none and all on other kinds of target"
    host=$(rustc -vV | sed -n 's/^host: //p')
    all=libm,std,simd,micromath,heapless,defmt
    for target in $host thumbv6m-none-eabi thumbv7em-none-eabihf wasm32-unknown-unknown; do
        case " ${skipped[*]-} " in *" target $target "*) continue ;; esac
        alone=("" "$all")
        [[ $target != "$host" ]] || alone=("" libm std simd micromath heapless defmt "$all")
        for features in "${alone[@]}"; do
            echo "$target [$features]"
            CARGO_TARGET_DIR=target/features cargo clippy -p nanospectra --quiet --target "$target" --no-default-features \
                --features "$features" -- -D warnings
        done
    done

    step "other targets: the crates for devices and for the web"
    for target in thumbv6m-none-eabi thumbv7em-none-eabihf thumbv8m.main-none-eabihf riscv32imac-unknown-none-elf; do
        case " ${skipped[*]-} " in *" target $target "*) continue ;; esac
        (cd examples/firmware && cargo clippy --quiet --target "$target" --bins --tests -- -D warnings)
    done
    case " ${skipped[*]-} " in
    *" target thumbv7em-none-eabihf "*) ;;
    *) (cd examples/firmware && cargo clippy --quiet --target thumbv7em-none-eabihf --no-default-features \
        --features measure -- -D warnings) ;;
    esac
    (cd examples/firmware && cargo clippy --quiet --bins --tests -- -D warnings)
    (cd examples/firmware/decode && cargo clippy --quiet -- -D warnings)
    case " ${skipped[*]-} " in
    *" target wasm32-unknown-unknown "*) ;;
    *) (cd examples/web && cargo clippy --quiet -- -D warnings) ;;
    esac

    step "other targets, devices: the same bits, instructions and bytes"
    bash tests/devices.sh --install

    step "other targets, the web: the package in node, the page in a browser"
    bash examples/web/test.sh
}

step "formatting"
cargo fmt --all --check
for crate in examples/firmware examples/firmware/decode examples/web; do
    cargo fmt --manifest-path "$crate/Cargo.toml" --check
done

mkdir -p target
others_log=target/other_targets.log
other_targets >"$others_log" 2>&1 &
others=$!
trap 'kill "$others" 2>/dev/null || true' EXIT

step "lints, of everything"
cargo clippy --workspace --all-targets -- -D warnings
cargo clippy -p nanospectra --all-targets --all-features -- -D warnings

step "documentation"
RUSTDOCFLAGS="-D warnings" cargo doc -p nanospectra --no-deps --all-features

step "tests, with the default features, as a release"
cargo test --release --workspace
step "Fast, over every fifth f32"
NANOSPECTRA_STRIDE=5 cargo test -p nanospectra --release --test spectrum every_f32
step "all 2^24 sRGB colours there and back with the default map, every eighth with the others"
NANOSPECTRA_STRIDE=1 cargo test -p nanospectra --release --test upsample all::cubic
NANOSPECTRA_STRIDE=2 cargo test -p nanospectra --release --test upsample all:: -- --skip cubic
step "what features could change: with every one, then with none, and with checks for overflow"
harnesses() { for name; do echo "--test $name"; done; }
# shellcheck disable=SC2046
cargo test -p nanospectra --all-features --lib $(harnesses spectrum path sensor upsample)
cargo test -p nanospectra-bits --features simd
cargo test -p nanospectra --all-features --doc
# shellcheck disable=SC2046
cargo test -p nanospectra --no-default-features --lib $(harnesses spectrum color matter path radiometry sensor upsample)
cargo test -p nanospectra --no-default-features --doc

step "the benches run and check their results"
cargo bench -p nanospectra-benches --bench observer --bench color --bench sensor --bench upsample --bench peers -- --test

step "what accuracy costs: every figure as it is on record, and the README as the record makes it"
cargo run --release -p nanospectra-cost -- --quick --check

step "the packages are complete"
cargo package -p nanospectra -p nanospectra-cli --allow-dirty

step "other targets"
outcome=0
wait "$others" || outcome=$?
trap - EXIT
cat "$others_log"
((outcome == 0))

for what in "${skipped[@]-}"; do
    [[ -z $what ]] || echo "SKIPPED  $what"
done
step "all passed"
