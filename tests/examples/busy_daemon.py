#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""In the place of a daemon: answers every submission twice with 503 and `Retry-After: 1`, then with a refusal. Writes a line
for each attempt into DIARY: its Idempotency-Key, and the milliseconds since the one before (0 for the first).

    busy_daemon.py PORT_FILE DIARY
"""
import http.server
import json
import pathlib
import sys
import time

REFUSAL = {"title": "The document is refused", "status": 422, "detail": "it has a problem",
           "errors": [{"pointer": "/the/place", "code": "missing", "detail": "it is missing"}]}


class Handler(http.server.BaseHTTPRequestHandler):
    attempts = 0
    last = 0.0

    def do_POST(self):
        self.rfile.read(int(self.headers["Content-Length"]))
        now = time.monotonic()
        is_first = Handler.attempts % 3 == 0
        with open(sys.argv[2], "a") as diary:
            print(self.headers["Idempotency-Key"], 0 if is_first else round(1000 * (now - Handler.last)), file=diary)
        Handler.last = now
        Handler.attempts += 1
        is_refusal = Handler.attempts % 3 == 0
        body = json.dumps(REFUSAL if is_refusal else {"title": "Busy", "status": 503}).encode()
        self.send_response(422 if is_refusal else 503)
        if not is_refusal:
            self.send_header("Retry-After", "1")
        self.send_header("Content-Length", str(len(body)))
        self.end_headers()
        self.wfile.write(body)

    def log_message(self, *_):
        pass


server = http.server.HTTPServer(("127.0.0.1", 0), Handler)
pathlib.Path(sys.argv[1]).write_text(str(server.server_address[1]))
server.serve_forever()
