#!/usr/bin/env bash
# Builds each package as it would be published and runs its tests from there: what a test needs must be in its package.
#
#   tests/packages.sh            all packages
#   tests/packages.sh NAME       the tests of this name only, as `cargo test NAME`
set -euo pipefail
cd "$(dirname "$0")/.."
target=$(cargo metadata --format-version 1 --no-deps --offline | sed 's/.*"target_directory":"\([^"]*\)".*/\1/')
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
names=(cmra-engine cmra-studies cmra-oracle cmra)
cargo package --locked --workspace --exclude cmra-benches --no-verify --allow-dirty --quiet
version=$(cargo pkgid -p cmra | sed 's/.*[#@]//')
mkdir "$work/.cargo"
echo '[patch.crates-io]' > "$work/.cargo/config.toml"
for name in "${names[@]}"; do
    tar xzf "$target/package/$name-$version.crate" -C "$work"
    if [ "$name" != cmra ]; then
        echo "$name = { path = \"$name-$version\" }" >> "$work/.cargo/config.toml"
    fi
done
for name in "${names[@]}"; do
    (cd "$work/$name-$version" && CARGO_TARGET_DIR="$target/packages" cargo test --quiet "$@")
done
