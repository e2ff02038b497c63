# SPDX-License-Identifier: Apache-2.0
# The daemon on Debian 13: Embree 4, cpp-httplib 0.18 and an SQLite with the fixes that Debian 12's lacks.
#   docker build -t bouguer . && docker run -p 8080:8080 -v bouguer-data:/data bouguer

FROM debian:trixie-slim AS build
COPY client-examples/install-dependencies.sh /src/client-examples/
RUN /src/client-examples/install-dependencies.sh build
COPY CMakeLists.txt CMakePresets.json LICENSE /src/
COPY renderer /src/renderer
COPY api /src/api
COPY server /src/server
# The page that the daemon serves offers this scene, and shares this script with the page of client-examples.
COPY client-examples/scenes/lee/figure-4d.json /src/client-examples/scenes/lee/
COPY client-examples/web/daemon.js /src/client-examples/web/
WORKDIR /src
RUN cmake --preset release -DBOUGUER_BUILD_TESTS=OFF && cmake --build --preset release --target bouguer && \
    install -D --strip build/release/server/bouguer /out/bouguer
# The packages that own the shared libraries which the binary loads: what the runtime needs, and no list to keep.
RUN ldd /out/bouguer | awk '$3 ~ "^/" { print $3 }' | xargs realpath | xargs dpkg -S | cut -d: -f1 | sort -u > /out/packages

FROM debian:trixie-slim
COPY --from=build /out/packages /tmp/packages
RUN apt-get update && \
    xargs -a /tmp/packages env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends && \
    rm -rf /var/lib/apt/lists/* /tmp/packages && \
    useradd --system --uid 10001 --home-dir /data --shell /usr/sbin/nologin bouguer && \
    mkdir /data && chown bouguer:bouguer /data
COPY --from=build /out/bouguer /usr/local/bin/bouguer
USER bouguer
VOLUME /data
EXPOSE 8080
STOPSIGNAL SIGTERM
# bash opens the connection itself: no client needs to be in the image.
HEALTHCHECK --interval=30s --timeout=5s --start-period=10s --retries=3 \
    CMD ["/bin/bash", "-c", "exec 3<>/dev/tcp/127.0.0.1/8080 && printf 'GET /livez HTTP/1.1\\r\\nHost: localhost\\r\\nConnection: close\\r\\n\\r\\n' >&3 && read -r -t 4 status <&3 && [[ $status == *' 200 '* ]]"]
ENTRYPOINT ["/usr/local/bin/bouguer"]
CMD ["serve", "--listen", "0.0.0.0:8080", "--allow-remote", "--data", "/data"]
