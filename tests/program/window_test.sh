#!/bin/bash
# The walk in a real window, under Xvfb: stands still, walks, turns, changes a style, saves it, takes it back, takes a
# picture, survives a broken level file, and quits. Exit code 77 means skipped.
#   window_test.sh PROGRAM CONTENT_FOLDER
set -euo pipefail

program=$1
content=$2
for tool in Xvfb xdotool; do
    command -v "$tool" >/dev/null || { echo "skipped: $tool is not installed"; exit 77; }
done

work=$(mktemp -d)
export XDG_CACHE_HOME=$work/cache XDG_STATE_HOME=$work/state
xvfb=
walk=
clean_up() {
    [ -z "$walk" ] || kill "$walk" 2>/dev/null || true
    [ -z "$xvfb" ] || kill "$xvfb" 2>/dev/null || true
    rm -rf "$work"
}
trap clean_up EXIT

fail() {
    echo "FAILED: $*"
    echo "--- log of the program"
    cat "$work/log" 2>/dev/null || true
    exit 1
}

# wait_for SECONDS WHAT COMMAND...: until the command succeeds.
wait_for() {
    local tries=$(($1 * 10)) what=$2
    shift 2
    until "$@"; do
        tries=$((tries - 1))
        [ "$tries" -gt 0 ] || fail "waited in vain for $what"
        kill -0 "$walk" 2>/dev/null || fail "the program ended while waiting for $what"
        sleep 0.1
    done
}

says() { grep -q "$@"; }
is_gone() { ! kill -0 "$walk" 2>/dev/null; }
press() { xdotool key --clearmodifiers "$@"; sleep 0.3; }
geometry() { xdotool getwindowgeometry "$(xdotool search --name 'prism.level.json' | head -n 1)" | grep -o '[0-9]*x[0-9]*'; }
has_size() { [ "$(geometry)" = "$1" ]; }
# Of the program's processor time, in hundredths of a second.
used() { sed 's/.*) //' "/proc/$walk/stat" | awk '{ print $12 + $13 }'; }
hold() { xdotool keydown "$1"; sleep 0.6; xdotool keyup "$1"; sleep 0.2; }

cp -r "$content/levels" "$content/models" "$content/maps" "$work/"
cd "$work"
level=levels/prism.level.json
plan='"plan": {"position": [0, 4, 0], "look_at": [0, 0, 0], "orthographic": {"height_m": 6}}'
sed -i "s|^  \"cameras\": {|&\n    $plan,|" "$level"

# Without a display it says so, and what to do instead.
status=0
env -u DISPLAY -u WAYLAND_DISPLAY "$program" walk "$level" 2>log || status=$?
[ "$status" = 2 ] || fail "without a display the exit code is $status, not 2"
says display log || fail "the message does not speak of the display"

# A server that resets when its last client is gone refuses the next one for a moment.
Xvfb -noreset -displayfd 3 -screen 0 1024x768x24 3>display >/dev/null 2>&1 &
xvfb=$!
for _ in $(seq 50); do [ -s display ] && break; sleep 0.1; done
[ -s display ] || { echo "skipped: Xvfb does not start here"; exit 77; }
DISPLAY=:$(cat display)
export DISPLAY

"$program" walk "$level" --size 640x480 >out 2>log &
walk=$!
has_window() { xdotool search --name 'prism.level.json' >/dev/null 2>&1; }
wait_for 60 "the window" has_window
xdotool windowfocus --sync "$(xdotool search --name 'prism.level.json' | head -n 1)"
sleep 2

# A walk that stands still sleeps: three hundredths of a core at most.
sleeps() {
    local before
    before=$(used)
    sleep 2
    [ $(($(used) - before)) -le 6 ]
}
wait_for 2 "the walk that stands still to sleep" sleeps

# The whole screen, and back.
press F11
wait_for 5 "the full screen" has_size 1024x768
press F11
wait_for 5 "the window to come back" has_size 640x480

# A picture, a walk, a turn, and another picture: from another place, and the first is still there.
press F12
has_picture() { [ -s "levels/prism_00$1.png" ]; }
wait_for 10 "the first picture" has_picture 1
cp levels/prism_001.png first.png
hold w
hold Left
press F12
wait_for 10 "the second picture" has_picture 2
cmp -s levels/prism_001.png first.png || fail "the second picture replaced the first"
cmp -s levels/prism_001.png levels/prism_002.png && fail "walking and turning changed nothing in the picture"
[ "$(grep -c -- '--eye' log)" = 2 ] || fail "the log does not name the view of each picture"
[ "$(grep -o -- '--eye [^ ]*' log | sort -u | wc -l)" = 2 ] || fail "W did not move the eye"
[ "$(head -c 4 levels/prism_001.png | tail -c 3)" = PNG ] || fail "the picture is no PNG"

# The object under the cross-hair gets another style, and the file says so; its comments stay.
press 0
press Tab
press ctrl+s
style_of_assign() { sed -n '/"assign"/,/\]/p' "$level" | grep -o '"style": *"[a-z_]*"' | tail -n 1 | grep -o '[a-z_]*"$' | tr -d '"'; }
first_style=drawn
is_restyled() { [ "$(style_of_assign)" != "$first_style" ]; }
wait_for 5 "the saved style" is_restyled
says 'The prism of' "$level" || fail "the comment is gone"
"$program" check "$level" >/dev/null 2>check_log || fail "the saved level is wrong: $(cat check_log)"

# Undoing after saving, then saving, is told to the file, too.
press ctrl+z
press ctrl+s
is_back() { [ "$(style_of_assign)" = "$first_style" ]; }
wait_for 5 "the style that was taken back" is_back

# What the cross-hair is on is hidden, and the file says so; then all is shown again. A path that plays is stopped by Esc.
press 0
press h
press ctrl+s
is_hidden() { says '"visible": false' "$level"; }
wait_for 5 "the saved rule that hides" is_hidden
sleep 1
press alt+h
press ctrl+s
is_shown() { ! is_hidden; }
wait_for 5 "the rule that hides to go" is_shown
press p
press Escape
is_gone && fail "Esc ended the walk while a path played"

# A broken level leaves the last good state on screen; once it is right again, all goes on.
good=$(cat "$level")
echo '{ broken' >"$level"
sleep 1.5
is_gone && fail "a broken level ended the walk"
press F12
wait_for 10 "a picture beside a broken level" has_picture 3
printf '%s\n' "$good" >"$level"
sleep 1.5

# A plan stands as it is until the walker moves, who sees in perspective; what was saved since has kept it in the level.
press 1
press F12
wait_for 10 "the picture of the plan" has_picture 4
hold w
press F12
wait_for 10 "the picture after the plan" has_picture 5
[ "$(grep -o -- '--ortho 6$\|--fov-deg 60$' log | tail -n 2 | tr '\n' ' ')" = "--ortho 6 --fov-deg 60 " ] ||
    fail "the plan is not in parallel projection, or walking from it not in perspective"
grep -qF "$plan" "$level" || fail "saving lost the parallel projection of a camera"

# The mouse: a click takes it, Esc gives it back, a second Esc does nothing; Q quits.
xdotool click 1
sleep 0.3
press q
is_gone && fail "Q quit while the mouse was taken"
press Escape
press Escape
is_gone && fail "Esc ended the walk"
press q
wait_for_end() { for _ in $(seq 100); do is_gone && return 0; sleep 0.1; done; return 1; }
wait_for_end || fail "Q did not end the walk"
status=0
wait "$walk" || status=$?
walk=
[ "$status" = 0 ] || fail "the exit code is $status"

# A walk that is killed loses nothing: the next one offers what it had not saved.
before=$(style_of_assign)
"$program" walk "$level" --size 640x480 >out 2>>log &
walk=$!
wait_for 60 "the second window" has_window
xdotool windowfocus --sync "$(xdotool search --name 'prism.level.json' | head -n 1)"
sleep 2
press 0
press Tab
sleep 5
kill -9 "$walk"
wait "$walk" 2>/dev/null || true
[ "$(style_of_assign)" = "$before" ] || fail "the level was saved by itself"
ls levels/.hatchway-*.unsaved.json >/dev/null 2>&1 || fail "the changes are not kept beside the level"
"$program" walk "$level" --size 640x480 >out 2>>log &
walk=$!
wait_for 60 "the third window" has_window
xdotool windowfocus --sync "$(xdotool search --name 'prism.level.json' | head -n 1)"
sleep 2
press ctrl+y
press ctrl+s
is_saved() { [ "$(style_of_assign)" != "$before" ]; }
wait_for 5 "what the killed walk had not saved" is_saved
press q
wait_for_end || fail "Q did not end the last walk"
walk=
[ -z "$(ls -A levels | grep '^\.hatchway-')" ] || fail "something was left beside the level: $(ls -A levels)"

# A model whose name is almost as long as a file system allows can be saved as a level.
stem=$(printf 'a%.0s' $(seq 246))
cp models/prism.glb "models/$stem.glb"
"$program" walk "models/$stem.glb" --size 640x480 >out 2>>log &
walk=$!
has_long_window() { xdotool search --name 'aaaaaaaa' >/dev/null 2>&1; }
wait_for 60 "the window of the long name" has_long_window
xdotool windowfocus --sync "$(xdotool search --name 'aaaaaaaa' | head -n 1)"
sleep 2
press Tab
press ctrl+s
press ctrl+s
has_level() { [ -s "models/${stem:2}.level.json" ]; }
wait_for 10 "the level with the long name" has_level
sleep 2
is_gone && fail "saving under a long name ended the walk"
press q
wait_for_end || fail "Q did not end the walk of the long name"
walk=
echo "walked, turned, restyled, saved, undone, photographed, quit"
