"""Job templates of Open Job Description, checked against what the specification "2023-09" (with its extension TASK_CHUNKING) says of
them: keys, types, lengths, names, ranges of integers, references in format strings and where they may stand, dependencies of steps.
Environments, host requirements and embedded files are not ours, and are refused.

    check(template) -> [fault, ...]        "steps[0].name: ..."
"""
import re

IDENTIFIER = re.compile(r"[A-Za-z_][A-Za-z0-9_]{0,63}\Z")
REFERENCE = re.compile(r"\{\{\s*(.*?)\s*\}\}")
RANGE_ITEM = re.compile(r"\s*(-?\d+)\s*(?:-\s*(-?\d+)\s*(?::\s*(-?\d+))?)?\s*\Z")
EXTENSIONS = ("TASK_CHUNKING",)

PARAMETERS = {  # beside name, type, description, default, allowedValues, userInterface
    "STRING": {"minLength": int, "maxLength": int},
    "PATH": {"minLength": int, "maxLength": int, "objectType": ("FILE", "DIRECTORY"), "dataFlow": ("NONE", "IN", "OUT", "INOUT")},
    "INT": {"minValue": int, "maxValue": int},
    "FLOAT": {"minValue": float, "maxValue": float},
}


def expand_range(text):
    """The integers of a range expression, ascending; ValueError for what is none."""
    values = []
    for item in str(text).split(","):
        found = RANGE_ITEM.match(item)
        if not found:
            raise ValueError(f"'{text}' is no range of integers")
        first, last, step = int(found[1]), int(found[2] or found[1]), int(found[3] or 1)
        if step == 0 or (last - first) * step < 0:
            raise ValueError(f"'{item}' has no numbers")
        values += range(first, last + (1 if step > 0 else -1), step)
    if len(set(values)) != len(values):
        raise ValueError(f"'{text}' names a number twice")
    return sorted(values)


class Check:
    def __init__(self):
        self.faults = []

    def fault(self, where, what):
        self.faults.append(f"{where}: {what}")

    def keys(self, value, where, required, optional=()):
        if not isinstance(value, dict):
            self.fault(where, "must be an object")
            return False
        for key in required:
            if key not in value:
                self.fault(where, f"{key} is missing")
        for key in value:
            if key not in required and key not in optional:
                self.fault(where, f"{key} is not known here")
        return all(key in value for key in required)

    def text(self, value, where, longest, names=None):
        """A string; with `names` a format string that may refer to these."""
        if not isinstance(value, str) or not 1 <= len(value) <= longest:
            self.fault(where, f"must be a text of 1 to {longest} characters")
        elif names is not None:
            if REFERENCE.sub("", value).count("{{") or REFERENCE.sub("", value).count("}}"):
                self.fault(where, "braces that do not match")
            for name in REFERENCE.findall(value):
                if name not in names:
                    self.fault(where, f"there is no {name} here")

    def identifier(self, value, where):
        if not isinstance(value, str) or not IDENTIFIER.match(value):
            self.fault(where, f"{value!r} is no identifier")

    def listed(self, value, where, most):
        if not isinstance(value, list) or not 1 <= len(value) <= most:
            self.fault(where, f"must be a list of 1 to {most}")
            return []
        return value

    # ---- parameters of the job

    def parameter(self, p, where):
        kind = p.get("type") if isinstance(p, dict) else None
        if kind not in PARAMETERS:
            return self.fault(where, f"type {kind!r}")
        own = PARAMETERS[kind]
        if not self.keys(p, where, ("name", "type"), ("description", "default", "allowedValues", "userInterface", *own)):
            return
        self.identifier(p["name"], f"{where}.name")
        if "description" in p:
            self.text(p["description"], f"{where}.description", 2048)
        for key, wanted in own.items():
            if key not in p:
                continue
            if isinstance(wanted, tuple) and p[key] not in wanted:
                self.fault(f"{where}.{key}", f"must be one of {wanted}")
            if not isinstance(wanted, tuple) and (isinstance(p[key], bool) or not isinstance(p[key], (int, wanted))):
                self.fault(f"{where}.{key}", f"must be of type {wanted.__name__}")
        if "default" in p and not self.faults:
            self.default(p, f"{where}.default")

    def default(self, p, where):
        value = p["default"]
        if p["type"] in ("STRING", "PATH"):
            if not isinstance(value, str) or not p.get("minLength", 0) <= len(value) <= p.get("maxLength", 1024):
                self.fault(where, "is no text of an allowed length")
        elif isinstance(value, bool) or not isinstance(value, int if p["type"] == "INT" else (int, float)):
            self.fault(where, f"is no {p['type']}")
        elif not p.get("minValue", value) <= value <= p.get("maxValue", value):
            self.fault(where, "is not between minValue and maxValue")
        if "allowedValues" in p and value not in p["allowedValues"]:
            self.fault(where, "is not among allowedValues")

    # ---- steps

    def task_parameter(self, t, where, names, defaults, chunking):
        kind = t.get("type") if isinstance(t, dict) else None
        if kind not in ("INT", "CHUNK[INT]"):  # FLOAT, STRING and PATH are none of ours
            return self.fault(where, f"type {kind!r}")
        if kind == "CHUNK[INT]" and not chunking:
            self.fault(where, "CHUNK[INT] needs the extension TASK_CHUNKING")
        if not self.keys(t, where, ("name", "type", "range") + (("chunks",) if kind == "CHUNK[INT]" else ())):
            return
        self.identifier(t["name"], f"{where}.name")
        if isinstance(t["range"], list):
            self.listed(t["range"], f"{where}.range", 1024)
        else:
            self.text(t["range"], f"{where}.range", 1024, names)
            try:
                expand_range(REFERENCE.sub(lambda m: str(defaults.get(m[1], 1)), t["range"]))
            except ValueError as error:
                self.fault(f"{where}.range", str(error))
        if kind == "CHUNK[INT]" and self.keys(t["chunks"], f"{where}.chunks", ("defaultTaskCount", "rangeConstraint"), ("targetRuntimeSeconds",)):
            self.count(t["chunks"]["defaultTaskCount"], f"{where}.chunks.defaultTaskCount", names)
            if "targetRuntimeSeconds" in t["chunks"]:
                self.count(t["chunks"]["targetRuntimeSeconds"], f"{where}.chunks.targetRuntimeSeconds", names, least=0)
            if t["chunks"]["rangeConstraint"] not in ("CONTIGUOUS", "NONCONTIGUOUS"):
                self.fault(f"{where}.chunks.rangeConstraint", "must be CONTIGUOUS or NONCONTIGUOUS")

    def count(self, value, where, names, least=1):
        if isinstance(value, str):
            self.text(value, where, 1024, names)
        elif isinstance(value, bool) or not isinstance(value, int) or value < least:
            self.fault(where, f"must be a whole number from {least}, or a format string")

    def action(self, action, where, names):
        if not self.keys(action, where, ("command",), ("args", "timeout", "cancelation")):
            return
        self.text(action["command"], f"{where}.command", 1024, names)
        for i, argument in enumerate(action.get("args", [])):
            self.text(argument, f"{where}.args[{i}]", 32768, names)
        if "timeout" in action:
            self.count(action["timeout"], f"{where}.timeout", names)
        if "cancelation" in action:
            cancel, place = action["cancelation"], f"{where}.cancelation"
            if self.keys(cancel, place, ("mode",), ("notifyPeriodInSeconds",)):
                if cancel["mode"] not in ("TERMINATE", "NOTIFY_THEN_TERMINATE"):
                    self.fault(place, "mode")
                if "notifyPeriodInSeconds" in cancel and (cancel["mode"] == "TERMINATE" or not 1 <= cancel["notifyPeriodInSeconds"] <= 600):
                    self.fault(place, "notifyPeriodInSeconds")

    def step(self, step, where, names, defaults, chunking, before):
        if not self.keys(step, where, ("name", "script"), ("description", "dependencies", "parameterSpace")):
            return
        self.text(step["name"], f"{where}.name", 64)
        for i, dependency in enumerate(step.get("dependencies", [])):
            if self.keys(dependency, f"{where}.dependencies[{i}]", ("dependsOn",)) and dependency["dependsOn"] not in before:
                self.fault(f"{where}.dependencies[{i}]", "must name a step before this one")
        own = {"Session.WorkingDirectory"}
        space = step.get("parameterSpace")
        if space is not None and self.keys(space, f"{where}.parameterSpace", ("taskParameterDefinitions",), ("combination",)):
            tasks = self.listed(space["taskParameterDefinitions"], f"{where}.parameterSpace.taskParameterDefinitions", 16)
            for i, t in enumerate(tasks):
                self.task_parameter(t, f"{where}.parameterSpace.taskParameterDefinitions[{i}]", names, defaults, chunking)
            own |= {f"Task.{raw}Param.{t.get('name')}" for t in tasks for raw in ("", "Raw")}
        script = step["script"]
        if self.keys(script, f"{where}.script", ("actions",)) and self.keys(script["actions"], f"{where}.script.actions", ("onRun",)):
            self.action(script["actions"]["onRun"], f"{where}.script.actions.onRun", names["session"] | own)


class Names(dict):
    """What may be referred to: of PATH parameters only their raw values while a job is made, all in a session."""

    def __init__(self, parameters):
        raw = {f"RawParam.{p['name']}" for p in parameters}
        super().__init__(template=raw | {f"Param.{p['name']}" for p in parameters if p["type"] != "PATH"},
                         session=raw | {f"Param.{p['name']}" for p in parameters})

    def __contains__(self, name):
        return name in self["template"]


def check(template):
    c = Check()
    if not c.keys(template, "template", ("specificationVersion", "name", "steps"), ("description", "parameterDefinitions", "extensions", "$schema")):
        return c.faults
    if template["specificationVersion"] != "jobtemplate-2023-09":
        c.fault("specificationVersion", "must be jobtemplate-2023-09")
    extensions = template.get("extensions", [])
    for extension in extensions:
        if extension not in EXTENSIONS:
            c.fault("extensions", f"{extension} is not known")
    parameters = c.listed(template["parameterDefinitions"], "parameterDefinitions", 50) if "parameterDefinitions" in template else []
    for i, p in enumerate(parameters):
        c.parameter(p, f"parameterDefinitions[{i}]")
    if c.faults:
        return c.faults
    given = [p["name"] for p in parameters]
    if len(set(given)) != len(given):
        c.fault("parameterDefinitions", "a name is there twice")
    names = Names(parameters)
    defaults = {f"Param.{p['name']}": p["default"] for p in parameters if "default" in p}
    c.text(template["name"], "name", 128, names)
    if "description" in template:
        c.text(template["description"], "description", 2048)
    before = []
    for i, step in enumerate(c.listed(template["steps"], "steps", 100)):
        c.step(step, f"steps[{i}]", names, defaults, "TASK_CHUNKING" in extensions, before)
        if isinstance(step, dict):
            if step.get("name") in before:
                c.fault(f"steps[{i}]", "its name is there twice")
            before.append(step.get("name"))
    return c.faults
