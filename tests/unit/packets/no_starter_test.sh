#!/usr/bin/env bash
# Starters are made of the steps' solutions; what stands beside them in solutions/ has none and is not even read.
set -u
starters=$1
solutions=$2
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
failed=0
fail() { echo "FAILED: $*"; failed=1; }

cp -r "$solutions" "$dir/solutions" || exit 1
for step in "$dir"/solutions/[0-9]*/; do mkdir -p "$dir/steps/$(basename "$step")"; done
echo '//> 9.9 a task in packets, never closed' >> "$dir/solutions/packets/packets.cpp"
"$starters" "$dir/solutions" "$dir/steps" > "$dir/said" 2>&1 || fail "starters: $(cat "$dir/said")"
"$starters" --check "$dir/solutions" "$dir/steps" || fail "what was written is not what is checked"
[ ! -e "$dir/steps/packets" ] || fail "steps/packets was made"
expected=$(cd "$dir/solutions" && ls [0-9]*/*.cpp)
got=$(cd "$dir/steps" && find . -type f | sed 's|^\./||' | sort)
[ -n "$got" ] && [ "$got" = "$(sort <<<"$expected")" ] || fail "starters of other files: $got"
# In a step the same line is an error: the check above is one.
echo '//> 9.9 never closed' >> "$dir/solutions/2_phong/phong.cpp"
if "$starters" "$dir/solutions" "$dir/steps" > /dev/null 2>&1; then fail "an open region in a step passes"; fi
exit $failed
