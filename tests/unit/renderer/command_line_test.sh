#!/usr/bin/env bash
# The render program from outside: what it returns, what it says, what it leaves behind.
set -u
render=$1
starter=$2
scenes=$3
scene=$scenes/1_ray_casting/one_sphere.pov
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
failed=0

expect() { # STATUS PATTERN ARGUMENTS...: what it prints must match the pattern
    local status=$1 pattern=$2 out
    shift 2
    out=$("$@" 2>&1 </dev/null)
    local got=$?
    if [ $got -ne "$status" ] || ! grep -qE -- "$pattern" <<<"$out"; then
        echo "FAILED: $*: status $got, expected $status; expected to read /$pattern/, got:"
        echo "$out" | head -5
        failed=1
    fi
}

expect 0 '^$' "$render" "$scene" -o "$dir/a.exr" --width 32 --height 24 --stats "$dir/stats.json"
[ -s "$dir/a.exr" ] || { echo "FAILED: no picture"; failed=1; }
grep -q '"unfinished":\[\]' "$dir/stats.json" || { echo "FAILED: statistics"; failed=1; }
grep -q '"residual":{"mean":0,"max":0,' "$dir/stats.json" || { echo "FAILED: nothing was pruned"; failed=1; }
expect 0 '^$' "$render" "$scenes/3_recursion/depth_0.pov" -o "$dir/m.exr" --width 32 --height 24 --stats "$dir/stats.json"
grep -q '"residual":{"mean":0\.[0-9]*,"max":1,' "$dir/stats.json" || { echo "FAILED: no residual"; failed=1; }
expect 0 'residual: rays that were not traced weigh 1;' "$render" "$scenes/3_recursion/depth_0.pov" --explain 20,10 --width 32 --height 24
expect 0 '^$' "$render" "$scene" -o "$dir/a.png" --width 32 --height 24
[ "$(head -c 8 "$dir/a.png" | od -An -tx1 | tr -d ' ')" = 89504e470d0a1a0a ] || { echo "FAILED: no PNG"; failed=1; }
expect 2 'no/b.png: cannot write the picture \(.+\)' "$render" "$scene" -o "$dir/no/b.png" --width 32 --height 24
cp "$render" "$dir/alone"
expect 2 'only .exr can be written: .*rays-formats: No such file' "$dir/alone" "$scene" -o "$dir/b.png" --width 32 --height 24
expect 2 'which scene' "$render" -o "$dir/b.exr"
expect 2 'nowhere.pov' "$render" nowhere.pov -o "$dir/b.exr"
expect 2 'where to' "$render" "$scene"
expect 2 '1000000000' "$render" "$scene" -o "$dir/b.exr" --width 1000000000 --height 1000000000
expect 2 'samples' "$render" "$scene" -o "$dir/b.exr" --samples 0
expect 2 'pattern' "$render" "$scene" -o "$dir/b.exr" --pattern stars
expect 2 'filter' "$render" "$scene" -o "$dir/b.exr" --filter sinc
expect 2 'error' "$render" "$scene" -o "$dir/b.exr" --error -1
expect 2 'goes on' "$render" "$scene" -o "$dir/b.exr" --error 0.01 --pattern jittered
expect 0 '' "$render" "$scene" -o "$dir/b.exr" --samples 7 --filter mitchell
expect 2 'no such effect' "$render" "$scene" -o "$dir/b.exr" --without gravity
expect 2 'cannot write' "$render" "$scene" -o "$dir/no/b.exr"
expect 2 'cannot write the picture \(.*b\.partial\.unknown' "$render" "$scene" -o "$dir/b.unknown" --width 32 --height 24
expect 2 'explain' "$render" "$scene" --explain 400,2
expect 0 'camera ray' "$render" "$scene" --explain 160,120
expect 0 'leaves out' "$render" "$scene" --needs
expect 0 '"needed":true' "$render" "$scene" --needs --json
expect 2 'run with --help|not expected' "$render" "$scene" --fly
# A full disk: an error, the old picture kept, nothing half-written.
if [ -w /dev/full ]; then
    expect 2 'cannot write' "$render" "$scene" -o "$dir/c.exr" --stats /dev/full
    for size in 32 640; do
        ln -s /dev/full "$dir/full.exr.partial"
        expect 2 'cannot write the picture \(No space left on device\)' "$render" "$scene" -o "$dir/full.exr" --width $size --height 480
        [ ! -e "$dir/full.exr" ] || { echo "FAILED: a picture without room"; failed=1; }
    done
fi
# Files that may not grow are as good as a full disk.
expect 2 'full.png: cannot write the picture' bash -c 'trap "" XFSZ; ulimit -f 1; exec "$@"' - "$render" "$scene" -o "$dir/full.png" --width 640 --height 480
[ -z "$(ls "$dir" | grep full.*png)" ] || { echo "FAILED: a picture without room, or half of it"; failed=1; }
# Packets and single rays: the same picture.
for file in 3_recursion/glass_spheres 4_partitioning/sphereflake_2; do
    expect 0 '^$' "$render" "$scenes/$file.pov" -o "$dir/packets.exr" --width 61 --height 43
    expect 0 '^$' "$render" "$scenes/$file.pov" -o "$dir/single.exr" --width 61 --height 43 --no-packets
    cmp "$dir/packets.exr" "$dir/single.exr" || { echo "FAILED: --no-packets changes $file"; failed=1; }
done
# Who has closed standard output is told so.
if "$render" "$scene" --explain 160,120 >&- 2>"$dir/said" || ! grep -q 'standard output' "$dir/said"; then
    echo "FAILED: no standard output"
    failed=1
fi
# The starter renders, says what is missing, and where.
expect 0 'unfinished 1\.1 .*camera.cpp|unfinished 1\.1 .*ray_casting.cpp' "$starter" "$scene" -o "$dir/s.exr" --width 32 --height 24
[ -s "$dir/s.exr" ] || { echo "FAILED: the starter made no picture"; failed=1; }
[ -z "$(find "$dir" -name '*.partial*')" ] || { echo "FAILED: half-written files"; failed=1; }
exit $failed
