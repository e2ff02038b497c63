#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes api/openapi.json of api/openapi.yaml and the JSON Schemas beside it: one document that stands alone, which the
daemon serves. Run it after every change of those files; it needs PyYAML.

    api/make_openapi_json.py            writes api/openapi.json
    api/make_openapi_json.py --check    fails when api/openapi.json is not what it would write
"""
import json
import pathlib
import re
import sys

import yaml

FOLDER = pathlib.Path(__file__).resolve().parent
SCHEMAS = {"scene.schema.json": "Scene", "job.schema.json": "Job"}


class CoreLoader(yaml.SafeLoader):
    """Reads plain scalars by the core schema of YAML 1.2 [YAML 1.2.2, section 10.3.2], as OpenAPI asks for. PyYAML reads
    YAML 1.1, where 1e30 is a text, `no` is false and 2001-12-14 is a date."""


CoreLoader.yaml_implicit_resolvers = {}
for tag, pattern, first in (
    ("null", r"~|null|Null|NULL|", ["~", "n", "N", ""]),
    ("bool", r"true|True|TRUE|false|False|FALSE", "tTfF"),
    ("int", r"[-+]?[0-9]+", "-+0123456789"),
    ("float", r"[-+]?(\.[0-9]+|[0-9]+(\.[0-9]*)?)([eE][-+]?[0-9]+)?", "-+.0123456789"),
):
    CoreLoader.add_implicit_resolver(f"tag:yaml.org,2002:{tag}", re.compile(f"(?:{pattern})$"), list(first))


def component_of(ref, file):
    """The reference `ref` of the file `file` as one into the components of the whole."""
    target, _, fragment = ref.partition("#")
    target = target or file
    if target not in SCHEMAS:
        return ref
    if not fragment:
        return "#/components/schemas/" + SCHEMAS[target]
    return "#/components/schemas/" + fragment.removeprefix("/$defs/")


def relinked(node, file):
    """A copy of `node`, a part of the file `file`, whose references lead into the whole."""
    if isinstance(node, list):
        return [relinked(item, file) for item in node]
    if not isinstance(node, dict):
        return node
    return {
        key: component_of(value, file) if key == "$ref" and isinstance(value, str) else relinked(value, file)
        for key, value in node.items()
        if key != "$schema"
    }


def bundle():
    whole = relinked(yaml.load((FOLDER / "openapi.yaml").read_text(), CoreLoader), "openapi.yaml")
    components = whole["components"]["schemas"]
    for file, name in SCHEMAS.items():
        schema = json.loads((FOLDER / file).read_text())
        parts = {name: schema, **schema.pop("$defs")}
        for part, definition in parts.items():
            if part in components:
                sys.exit(f"two schemas are called {part}")
            components[part] = relinked(definition, file)
    return json.dumps(whole, indent=1, ensure_ascii=False) + "\n"


def main():
    target = FOLDER / "openapi.json"
    text = bundle()
    if sys.argv[1:] == ["--check"]:
        if not target.exists() or target.read_text() != text:
            sys.exit("api/openapi.json is not what api/make_openapi_json.py makes: run it")
    elif sys.argv[1:]:
        sys.exit(__doc__)
    else:
        target.write_text(text)


if __name__ == "__main__":
    main()
