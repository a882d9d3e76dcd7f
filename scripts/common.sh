# shellcheck shell=bash
# What all scripts begin with: `. scripts/common.sh`, from the repository's root. Works with bash 3.2,
# which is what macOS has.
set -euo pipefail

# rustup puts cargo here; a shell that was open before does not know yet.
if ! command -v cargo >/dev/null && [ -x "$HOME/.cargo/bin/cargo" ]; then
    PATH="$HOME/.cargo/bin:$PATH"
fi

say() {
    printf '%s\n' "$*"
}

stop() {
    printf '\nstopped: %s\n' "$*" >&2
    exit 1
}

# check NAME COMMAND...: runs COMMAND under a heading, then tells how long it took; stops when it fails.
# bash ignores `set -e` in a function that is checked like this, so such functions chain with `&&`.
check() {
    local name="$1" start=$SECONDS
    shift
    printf '\n== %s\n' "$name"
    "$@" || stop "'$name' failed after $((SECONDS - start)) s"
    printf -- '-- %s: %s s\n' "$name" "$((SECONDS - start))"
}

# existing FILE...: those that exist, with colons between; fails when there is none.
existing() {
    local file list=""
    for file in "$@"; do
        [ ! -e "$file" ] || list="$list${list:+:}$file"
    done
    [ -n "$list" ] && printf '%s\n' "$list"
}

# The manifests of lavapipe, Mesa's Vulkan driver that draws on the CPU: one for each kind of processor.
lavapipe() {
    existing /usr/share/vulkan/icd.d/lvp_icd*.json /etc/vulkan/icd.d/lvp_icd*.json
}
