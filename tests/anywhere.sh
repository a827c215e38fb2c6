#!/usr/bin/env bash
# Runs the tests in surroundings that must make no difference to them: all of them once in each, or, with --long, those that have
# depended on their surroundings a hundred times besides.
#
#   tests/anywhere.sh             each surrounding once, in the usual profile
#   tests/anywhere.sh --quick     two of them that cost little, the tests of the terminal and of files only
#   tests/anywhere.sh --world     every surrounding but the load, those tests only
#   tests/anywhere.sh --long      each surrounding with the release profile, which is faster than any test may expect; then the hundred times
set -euo pipefail
cd "$(dirname "$0")/.."
how=${1:-}
work=$(mktemp -d)
load=()
# Nothing is left behind, whichever test failed: neither the load nor a folder.
tidy() {
    if [ ${#load[@]} -gt 0 ]; then kill "${load[@]}" 2> /dev/null || true; fi
    chmod -R u+rwx "$work"
    rm -rf "$work"
}
trap tidy EXIT
trap 'exit 130' INT TERM HUP
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
# The same where this user may set it up; what may not be is said.
permitted() {
    surrounding "$@"
    if "${before[@]}" true 2> /dev/null; then all "${only[@]}"; else echo "not permitted here: $name" >&2; fi
}
# After these commands of a shell.
after() { prepared=(bash -c "$1; exec \"\$@\"" after); }

# Those that have depended on speed or surroundings.
named=(worker:: progress:: terminal:: trouble:: hostile:: effects:: pages::tests mount_loads exports sweep::an_interrupted)
named+=(cli:: files:: kills:: outputs:: presets:: readers:: theme:: start:: input::)
only=()
if [ "$how" = --quick ] || [ "$how" = --world ]; then only=("${named[@]}"); fi
profile=()
if [ "$how" = --long ]; then profile=(--release); fi

build "${profile[@]}"
temporary=(TMPDIR="$work/a folder with spaces")
unset=(-u TERM -u LANG -u LC_ALL -u LC_CTYPE)
if [ "$how" = --quick ]; then
    surrounding "a folder with spaces, no HOME, TERM and LANG unset" env -u HOME "${unset[@]}" "${temporary[@]}"
    all "${only[@]}"
else
    surrounding "a folder with spaces for temporary files" env "${temporary[@]}"
    all "${only[@]}"
    surrounding "no HOME" env -u HOME
    all "${only[@]}"
    surrounding "TERM and LANG unset" env "${unset[@]}"
    all "${only[@]}"
fi
surrounding "inside tmux and GNU screen, over SSH, without colours, in few columns" env NO_COLOR=1 TMUX=/tmp/tmux-0/default,1,0 \
    STY=1.pts-0.host SSH_CONNECTION="10.0.0.1 1 10.0.0.2 22" SSH_TTY=/dev/pts/0 COLUMNS=20 LINES=5
all "${only[@]}"
if [ "$how" = --quick ]; then exit; fi

for locale in tr_TR.UTF-8 ja_JP.eucJP; do
    surrounding "locale $locale" env LANG=$locale LC_ALL=$locale
    all "${only[@]}"
done
after "umask 077"
surrounding "umask 077" "${prepared[@]}"
all "${only[@]}"
after "trap '' HUP"
surrounding "SIGHUP ignored" "${prepared[@]}"
all "${only[@]}"
after "ulimit -n 100"
surrounding "a hundred open files" "${prepared[@]}" env RUST_TEST_THREADS=2
all "${only[@]}"
mkdir "$work/bin"
for folder in ${PATH//:/ }; do
    for command in "$folder"/*; do ln -sf "$command" "$work/bin/"; done
done
rm -f "$work/bin/kill"
surrounding "no kill" env PATH="$work/bin"
all "${only[@]}"
after "mount --bind \"\$(command -v bash)\" /bin/sh"
permitted "/bin/sh is bash" unshare --mount "${prepared[@]}"
after "mount --bind '$PWD' '$PWD' && mount -o remount,bind,ro '$PWD' && cd \"\$PWD\""
permitted "a read-only checkout" unshare --mount "${prepared[@]}"
permitted "process numbers of its own" unshare --pid --fork --mount-proc
after "mount -t tmpfs none /proc"
# Tests of processes look there themselves.
whole=("${only[@]}")
only=(cli:: exports:: files:: libraries:: outputs:: presets:: readers::)
permitted "no /proc" unshare --mount "${prepared[@]}"
only=("${whole[@]}")
if [ "$how" = --world ]; then exit; fi

surrounding "one core" taskset -c 0
all
surrounding "sixteen threads" env RUST_TEST_THREADS=16
all
surrounding "beside load" env
for _ in 1 2 3 4; do (while :; do :; done) & load+=($!); done
all
kill "${load[@]}"
load=()
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
