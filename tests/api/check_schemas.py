#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Holds the JSON Schemas of api/ to the documents: every scene of client-examples and the well-formed document of
malformed_documents.json passes, every malformed document is refused, but for those whose row says `beyond_schema`
(names, geometry and sums are more than a schema can judge), which pass. Also: every example in the schemas is one.

Needs Python 3.9 with venv; jsonschema goes into build/schema-check, once. Usage: tests/api/check_schemas.py
"""
import json
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "support"))
import python_packages


def patched(base, operations):
    """`base` after a JSON Patch [RFC 6902] of add, remove and replace."""
    document = json.loads(json.dumps(base))
    for operation in operations:
        *path, last = [t.replace("~1", "/").replace("~0", "~") for t in operation["path"].split("/")[1:]]
        node = document
        for token in path:
            node = node[int(token) if isinstance(node, list) else token]
        if isinstance(node, list):
            last = int(last)
        if operation["op"] == "remove":
            del node[last]
        else:
            node[last] = operation["value"]
    return document


def object_of(pairs):
    """An object; its keys must differ, which Python's reader does not ask for."""
    if len({key for key, _ in pairs}) < len(pairs):
        raise ValueError("duplicate key")
    return dict(pairs)


def parsed(base, row):
    """The document of a row; None when it cannot be read as one."""
    if "hex" in row or "repeat" in row:
        return None
    text = row.get("text")
    if text is None:
        text = json.dumps(patched(base, row["patch"]), sort_keys=True, separators=(",", ":"))
        swap = row.get("then_replace")
        if swap:
            text = text.replace(swap["from"], swap["to"], 1)
    try:
        return json.loads(text, object_pairs_hook=object_of)
    except ValueError:
        return None


def schema_of(document, validators):
    """A bare scene is told by its format, as the service does."""
    is_scene = isinstance(document, dict) and document.get("format") == "bouguer-scene/1"
    return validators["scene" if is_scene else "job"]


def make_validators():
    from jsonschema import Draft202012Validator
    from referencing import Registry, Resource

    schemas = {name: json.loads((ROOT / "api" / f"{name}.schema.json").read_text()) for name in ("scene", "job")}
    registry = Registry().with_resources(
        [(f"{name}.schema.json", Resource.from_contents(schema)) for name, schema in schemas.items()])
    for schema in schemas.values():
        Draft202012Validator.check_schema(schema)
    return {name: Draft202012Validator({"$ref": f"{name}.schema.json"}, registry=registry) for name in schemas}


def check_examples(faults, validators):
    """Every `examples` and `default` of the schemas is valid where it stands."""
    from jsonschema import Draft202012Validator

    for name, validator in validators.items():
        file = f"{name}.schema.json"
        schema = json.loads((ROOT / "api" / file).read_text())
        parts = {"": schema, **{f"/$defs/{part}": value for part, value in schema["$defs"].items()}}
        for pointer, part in parts.items():
            here = Draft202012Validator({"$ref": f"{file}#{pointer}"}, registry=validator._registry)
            for example in part.get("examples", []):
                if not here.is_valid(example):
                    faults.append(f"{file}{pointer}: an example is not valid: {json.dumps(example)}")


def check_scenes(faults, validators):
    scenes = sorted((ROOT / "client-examples" / "scenes").rglob("*.json"))
    if not scenes:
        faults.append("there are no scenes in client-examples")
    for scene in scenes:
        document = json.loads(scene.read_text())
        for error in schema_of(document, validators).iter_errors(document):
            faults.append(f"{scene.relative_to(ROOT)}: {error.json_path}: {error.message[:200]}")
    return len(scenes)


def check_table(faults, validators):
    table = json.loads((ROOT / "tests" / "api" / "malformed_documents.json").read_text())
    for error in validators["job"].iter_errors(table["base"]):
        faults.append(f"the well-formed document: {error.json_path}: {error.message[:200]}")
    judged = 0
    for row in table["documents"]:
        document = parsed(table["base"], row)
        if document is None:
            continue
        judged += 1
        is_valid = schema_of(document, validators).is_valid(document)
        if is_valid != row.get("beyond_schema", False):
            faults.append(f"{row['name']}: the schema {'accepts' if is_valid else 'refuses'} it")
    return judged


def main():
    python_packages.enter("schema-check", ["jsonschema==4.23.0"])
    faults = []
    validators = make_validators()
    scenes = check_scenes(faults, validators)
    judged = check_table(faults, validators)
    check_examples(faults, validators)
    print(f"{scenes} scenes, {judged} malformed documents, {len(faults)} faults")
    sys.exit("\n".join(faults) or None)


if __name__ == "__main__":
    main()
