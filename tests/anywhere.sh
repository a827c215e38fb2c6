#!/usr/bin/env bash
# Runs the tests in surroundings that must make no difference to them: all of them once in each, or, with --long, those that have
# depended on their surroundings a hundred times besides.
#
#   tests/anywhere.sh             each surrounding once, in the usual profile
#   tests/anywhere.sh --quick     the surroundings that cost little, the tests of the terminal and of files only
#   tests/anywhere.sh --long      each surrounding with the release profile, which is faster than any test may expect; then the hundred times
set -euo pipefail
cd "$(dirname "$0")/.."
how=${1:-}
work=$(mktemp -d)
trap 'chmod -R u+rwx "$work"; rm -rf "$work"' EXIT
mkdir "$work/a folder with spaces"

# The programs of the tests: they are run from the folder of their package, as cargo does.
programs() {
    cargo test "$@" --no-run --message-format=json 2>/dev/null |
        sed -n 's/.*"manifest_path":"\([^"]*\)\/Cargo.toml".*"test":true.*"executable":"\([^"]*\)".*/\1 \2/p' | sort -u
}
build() {
    cargo test "$@" --no-run
    programs "$@" > "$work/programs"
    # A test that finds no program is no green test.
    test -s "$work/programs"
}
# Every program with these arguments, behind a command that sets the surroundings up.
all() {
    local folder program
    echo "== $name" >&2
    while read -r folder program; do
        (cd "$folder" && "${before[@]}" "$program" --quiet "$@") > "$work/out" 2>&1 < /dev/null ||
            { cat "$work/out"; echo "red: $name: $program"; exit 1; }
    done < "$work/programs"
}
surrounding() { name=$1; shift; before=("$@"); }

# Those that have depended on speed or surroundings.
named=(worker:: progress:: terminal:: trouble:: hostile:: effects:: pages::tests mount_loads exports sweep::an_interrupted)
only=()
if [ "$how" = --quick ]; then only=("${named[@]}"); fi
profile=()
if [ "$how" = --long ]; then profile=(--release); fi

build "${profile[@]}"
surrounding "a folder with spaces for temporary files" env TMPDIR="$work/a folder with spaces"
all "${only[@]}"
surrounding "no HOME" env -u HOME
all "${only[@]}"
surrounding "TERM and LANG unset" env -u TERM -u LANG -u LC_ALL -u LC_CTYPE
all "${only[@]}"
if [ "$how" = --quick ]; then exit; fi

surrounding "one core" taskset -c 0
all
surrounding "sixteen threads" env RUST_TEST_THREADS=16
all
surrounding "beside load" env
load=()
for _ in 1 2 3 4; do (while :; do :; done) & load+=($!); done
all
kill "${load[@]}"
other=(setpriv --reuid=nobody --regid=nogroup --clear-groups)
# Only root can become another user, and that one must be able to read this folder.
if [ "$(id -u)" = 0 ] && "${other[@]}" test -r "$PWD/Cargo.toml"; then
    surrounding "another user" "${other[@]}" env HOME=/nonexistent
    all
fi
if [ "$how" = --long ]; then
    surrounding "the named tests, again and again" env
    for _ in $(seq 100); do all "${named[@]}"; done
fi
