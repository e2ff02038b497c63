#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Builds the Dockerfile as it is, on a machine without a Docker engine (Debian 12 or 13, as root or with sudo), and
# renders a scene over HTTP inside. Not part of tests/run.sh: it takes minutes and some gigabytes of ${TMPDIR:-/tmp}.
#
#   tests/container.sh [SCENE.json]
#
# buildah builds with isolation "chroot", which shares the machine's network: the daemon answers on loopback. The base
# image is made by debootstrap from the distribution's own archive. Leaves nothing behind.
set -euo pipefail
cd "$(dirname "$0")/.."
[ "$(id -u)" -eq 0 ] || exec sudo --preserve-env=TMPDIR "$0" "$@"
scene=$(realpath "${1:-client-examples/scenes/amber-ball.json}")
port=8080

stage() {
    local name=$1 begin=$SECONDS
    shift
    echo "== $name"
    "$@"
    echo "== $name took $((SECONDS - begin)) s"
}

work=$(mktemp -d "${TMPDIR:-/tmp}/bouguer-container.XXXXXX")
export STORAGE_DRIVER=vfs BUILDAH_ISOLATION=chroot CONTAINERS_REGISTRIES_CONF="$work/registries.conf"
run_pid=
b() { buildah --root "$work/store" --runroot "$work/run" "$@"; }

# The daemon runs below buildah: the process group that this script started ends as one.
clean_up() {
    if [ -n "$run_pid" ]; then
        kill -TERM -- "-$run_pid" 2>/dev/null || true
        wait "$run_pid" 2>/dev/null || true
    fi
    b rm --all >/dev/null 2>&1 || true
    rm -rf --one-file-system "$work"
}
trap clean_up EXIT
trap 'exit 130' INT
trap 'exit 143' TERM HUP

install_tools() {
    local missing=()
    for tool in buildah debootstrap curl; do command -v "$tool" >/dev/null || missing+=("$tool"); done
    [ ${#missing[@]} -gt 0 ] || return 0
    export DEBIAN_FRONTEND=noninteractive
    apt-get -qq update
    apt-get -qq install -y --no-install-recommends "${missing[@]}" >/dev/null
}

make_base_image() {
    debootstrap --variant=minbase trixie "$work/root" >"$work/debootstrap.log" ||
        { tail -n 20 "$work/debootstrap.log" >&2; return 1; }
    # The machine's own way to the archive (proxy, certificates) holds inside, too, as it would with an engine.
    printf '%s\n' 'unqualified-search-registries = []' 'short-name-mode = "permissive"' \
        '[aliases]' '"debian" = "localhost/debian"' >"$CONTAINERS_REGISTRIES_CONF"
    local container
    container=$(b from scratch)
    b add -q "$container" "$work/root" / >/dev/null
    b config --cmd /bin/bash "$container"
    b commit -q "$container" localhost/debian:trixie-slim >/dev/null
    b rm "$container" >/dev/null
    rm -rf --one-file-system "$work/root"
}

build_image() { b bud --pull-never -t localhost/bouguer:test . ; }

render_inside() {
    local container
    container=$(b from --pull-never localhost/bouguer:test)
    b run "$container" -- /usr/local/bin/bouguer --version
    local command
    mapfile -t command < <(b inspect --type image --format '{{range .OCIv1.Config.Entrypoint}}{{println .}}{{end}}{{range .OCIv1.Config.Cmd}}{{println .}}{{end}}' localhost/bouguer:test | sed '/^$/d')
    echo "user $(b inspect --type image --format '{{.OCIv1.Config.User}}' localhost/bouguer:test), command: ${command[*]}"
    setsid buildah --root "$work/store" --runroot "$work/run" run "$container" -- "${command[@]}" >"$work/daemon.log" 2>&1 &
    run_pid=$!
    for _ in $(seq 100); do
        curl -sf "http://127.0.0.1:$port/readyz" >/dev/null && break
        kill -0 "$run_pid" 2>/dev/null || { cat "$work/daemon.log" >&2; return 1; }
        sleep 0.2
    done
    BOUGUER_URL="http://127.0.0.1:$port" client-examples/submit.sh "$scene" "$work/picture" || { cat "$work/daemon.log" >&2; return 1; }
    [ "$(head -c 8 "$work/picture.png" | od -An -tx1 | tr -d ' \n')" = 89504e470d0a1a0a ] || { echo "not a PNG" >&2; return 1; }
    echo "picture: $(stat -c %s "$work/picture.png") bytes PNG, $(stat -c %s "$work/picture.exr") bytes OpenEXR"
    # What HEALTHCHECK runs, inside.
    b run "$container" -- /bin/bash -c "exec 3<>/dev/tcp/127.0.0.1/$port && printf 'GET /livez HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n' >&3 && read -r -t 4 status <&3 && [[ \$status == *' 200 '* ]]"
    echo "health check: well"
}

if curl -s -o /dev/null "http://127.0.0.1:$port/"; then
    echo "Something answers on port $port already; stop it first" >&2
    exit 1
fi
stage "tools" install_tools
stage "base image" make_base_image
stage "image" build_image
b images --format '{{.Name}}:{{.Tag}} {{.Size}}'
stage "render inside" render_inside
echo "The container is well."
