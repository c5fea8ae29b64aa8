#!/usr/bin/env python3
"""Writes the tables of styles' parameters into level_files.md and the styles' own pages, from content/level.schema.json. Run
it after `hatchway schema --out content/level.schema.json`."""
import json
import pathlib
import re

DOCS = pathlib.Path(__file__).resolve().parent
BEGIN, END = "<!-- styles begin -->\n", "<!-- styles end -->\n"


def allowed(param):
    if "enum" in param:
        return ", ".join(f"`{name}`" for name in param["enum"])
    if param["type"] == "boolean":
        return "`true` or `false`"
    if "minimum" in param:
        return f"{param['minimum']:g} to {param['maximum']:g}"
    return "a colour" if "pattern" in param else "a map"


def table(style):
    params = dict(style["properties"])
    plugin = params.pop("plugin")
    rows = [f"### {plugin['const']}\n\n{plugin['description']}.\n\n| parameter | is | allowed | default |\n|---|---|---|---|\n"]
    for name, param in params.items():
        default = json.dumps(param.get("default", ""))
        rows.append(f"| `{name}` | {param['description'].rstrip('.')} | {allowed(param)} | `{default}` |\n")
    return "".join(rows)


def page_table(style):
    params = dict(style["properties"])
    params.pop("plugin")
    rows = ["| parameter | values | default | meaning |\n|---|---|---|---|\n"]
    for name, param in params.items():
        default = str(param.get("default", ""))
        default = default.lower() if default in ("True", "False") else re.sub(r"\.0$", "", default)
        values = allowed(param).replace("`", "").replace(" or ", ", ").replace("a colour", "colour").replace("a map", "map")
        rows.append(f"| `{name}` | {values} | {f'`{default}`' if default else ''} | {param['description']} |\n")
    return "".join(rows)


def write_pages(styles):
    for style in styles:
        page = DOCS.parent / "npr_plugins" / style["then"]["properties"]["plugin"]["const"] / "README.md"
        text = page.read_text()
        table_now = re.compile(r"^\| parameter \|.*\n(?:\|.*\n?)*", re.M)
        page.write_text(table_now.sub(lambda _: page_table(style["then"]), text))


def main():
    schema = json.loads((DOCS.parent / "content" / "level.schema.json").read_text())
    styles = schema["properties"]["styles"]["additionalProperties"]["allOf"]
    tables = "\n".join(table(style["then"]) for style in styles)
    write_pages(styles)
    manual = DOCS / "level_files.md"
    text = manual.read_text()
    manual.write_text(re.sub(f"{BEGIN}.*{END}", lambda _: f"{BEGIN}\n{tables}\n{END}", text, flags=re.S))


main()
