# SPDX-License-Identifier: Apache-2.0
"""For the tests of this folder: a client of a daemon that may be gone, stopped, full or hung at any moment."""
import http.client
import json
import time


class Answer:
    """What the daemon said: status, header fields by lower-case name, bytes."""

    def __init__(self, status, fields, body):
        self.status, self.fields, self.body = status, fields, body

    def json(self):
        return json.loads(self.body)


class DaemonClient:
    """Asks the daemon whose port stands in `port_file`, which is read anew each time: after a restart it is another."""

    def __init__(self, port_file):
        self.port_file = port_file

    def ask(self, method, path, body=None, fields=None, timeout_s=10):
        """One answer over a connection of its own, or None when there was none."""
        connection = None
        try:
            with open(self.port_file, encoding="ascii") as file:
                port = int(file.read())
            connection = http.client.HTTPConnection("127.0.0.1", port, timeout=timeout_s)
            connection.request(method, path, body, fields or {})
            response = connection.getresponse()
            names = {name.lower(): value for name, value in response.getheaders()}
            return Answer(response.status, names, response.read())
        except (OSError, ValueError, http.client.HTTPException):
            return None
        finally:
            if connection is not None:
                connection.close()

    def insist(self, method, path, body=None, fields=None, deadline_s=120, note=lambda answer: None):
        """Asks until there is an answer that is not "later" (429, 5xx, none). Every answer and None is shown to `note`."""
        end = time.monotonic() + deadline_s
        while True:
            answer = self.ask(method, path, body, fields)
            note(answer)
            if answer is not None and answer.status < 500 and answer.status != 429:
                return answer
            if time.monotonic() > end:
                said = "nothing" if answer is None else f"{answer.status} {answer.body[:300]!r}"
                raise TimeoutError(f"{method} {path} has no good answer for {deadline_s} s; last: {said}")
            time.sleep(0.1)
