#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""api/openapi.json, which the daemon serves, is valid OpenAPI 3.1 with valid schemas, and is what api/make_openapi_json.py
makes of api/openapi.yaml. That script reads YAML by rules of its own, so another reader of YAML 1.2 has to read the same.

Needs Python 3.10 with venv; the packages go into build/openapi-check, once. Usage: tests/api/validate_openapi.py
"""
import json
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
API = ROOT / "api"
sys.path[:0] = [str(ROOT / "tests" / "support"), str(API)]
sys.dont_write_bytecode = True
import python_packages

PACKAGES = ["openapi-spec-validator==0.9.0", "PyYAML==6.0.2", "ruamel.yaml==0.18.10"]


def is_what_is_made():
    made = subprocess.run([sys.executable, API / "make_openapi_json.py", "--check"], capture_output=True, text=True)
    return [made.stderr.strip()] if made.returncode else []


def reads_alike():
    import make_openapi_json
    import ruamel.yaml
    import yaml

    text = (API / "openapi.yaml").read_text()
    ours = yaml.load(text, make_openapi_json.CoreLoader)
    theirs = ruamel.yaml.YAML(typ="safe", pure=True).load(text)
    return [] if json.dumps(ours) == json.dumps(theirs) else ["openapi.yaml is read otherwise by a reader of YAML 1.2"]


def is_valid():
    from jsonschema import Draft202012Validator
    from jsonschema.exceptions import SchemaError
    from openapi_spec_validator import OpenAPIV31SpecValidator

    whole = json.loads((API / "openapi.json").read_text())
    faults = [f"{error.json_path}: {error.message}" for error in OpenAPIV31SpecValidator(whole).iter_errors()]
    for name, schema in whole["components"]["schemas"].items():
        try:
            Draft202012Validator.check_schema(schema)
        except SchemaError as error:
            faults.append(f"schema {name}: {error.json_path}: {error.message}")
    return faults


def main():
    python_packages.enter("openapi-check", PACKAGES)
    faults = is_what_is_made() + reads_alike() + is_valid()
    sys.exit("\n".join(faults) or None)


if __name__ == "__main__":
    main()
