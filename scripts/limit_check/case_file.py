# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""A model as a case file, in one of the ways in which users write them."""


def numbers(values):
    return "[" + ", ".join(repr(float(x)) for x in values) + "]"


def head(model):
    lines = [f'title = "{model.kind}"', ""]
    if model.gravity != 9.8:
        lines += ["[gravity]", f"acceleration = [0.0, 0.0, {-model.gravity!r}]", ""]
    for name, density in model.density.items():
        lines += [f"[materials.{name}]", f"density = {float(density)!r}", "young = 5.0e9", "poisson = 0.2", ""]
    lines += ["[contact]", f"friction = {model.friction!r}", ""]
    for one, other, angle in model.between:
        lines += ["[[contact.between]]", f'materials = ["{one}", "{other}"]', f"friction = {angle!r}", ""]
    if model.law_friction is not None:
        lines += ["[joint_laws.mortar]", "tension = 1.0e5", "cohesion = 2.0e5", "friction = 30.0", "compression = 5.0e6",
                  f"residual_friction = {model.law_friction!r}", "", "[joints]", 'default = "mortar"', ""]
    lines += ["[segments]", f'rule = "{model.rule}"'] + ([f"size = {model.size!r}"] if model.size is not None else []) + [""]
    if model.base is not None:
        lines += ["[base]", f"z = {model.base!r}"] + ([f"tilt = {numbers(model.tilt)}"] if any(model.tilt) else []) + [""]
    for part in (b for b in model.blocks if b.ground):
        (x0, y0, z0), (x1, y1, z1) = part.box
        lines += ["[[base.part]]", f"x = {numbers((x0, x1))}", f"y = {numbers((y0, y1))}", f"level = {float(z1 - z0)!r}", ""]
    return lines


def shape(block, model):
    corners = block.vertices
    n = len(corners) // 2
    if block.box:
        return [f"box = [{numbers(block.box[0])}, {numbers(block.box[1])}]"]
    along_x = len(set(corners[:n, 0])) == len(set(corners[n:, 0])) == 1 and (corners[:n, 1:] == corners[n:, 1:]).all()
    if along_x and model.rule == "rim":
        return ["polygon = [" + ", ".join(numbers(c[1:]) for c in corners[:n]) + "]", f"extrude = {numbers(sorted((corners[0, 0], corners[n, 0])))}"]
    return ["vertices = [" + ", ".join(numbers(c) for c in corners) + "]", f"faces = {[list(face) for face in block.faces]}"]


def block_lines(block, model):
    lines = ["[[block]]", f'name = "{block.name}"', f'material = "{block.material}"', *shape(block, model)]
    if block.fixed:
        lines.append("fixed = true")
    if model.turn:
        lines.append(f"rotate = {{ angle = {model.turn[0]!r}, about = {numbers(model.turn[1])} }}")
    return lines + [""]


def stones_lines(model, obj_name):
    supports = [f'"{block.name}"' for block in model.written if block.fixed]
    size = max(max(b.vertices.max(axis=0) - b.vertices.min(axis=0)) for b in model.written)
    angle, place = model.turn
    return ["[[stones]]", f'file = "{obj_name}"', 'unit = "m"', "supports = " + (f"[{', '.join(supports)}]" if supports else '"none"'),
            f"snap = {min(1e-3, 1e-4 * size)!r}", f"place = {numbers(place)}", f"turn = {angle!r}", ""]


def obj_text(model):
    lines, first = [], 1
    for block in [b for b in model.written if not b.stone] + model.outlines:
        lines.append(f"o {block.name}")
        lines += ["v " + " ".join(repr(float(x)) for x in corner) for corner in block.vertices]
        lines += ["f " + " ".join(str(first + i) for i in face) for face in block.faces]
        first += len(block.vertices)
    return "\n".join(lines) + "\n"


def write(model, path):
    """Writes `path` (.toml), and beside it an .obj if the model is a file of stones."""
    lines = head(model)
    if model.form == "stones":
        obj = path.with_suffix(".obj")
        obj.write_text(obj_text(model))
        lines += stones_lines(model, obj.name)
    else:
        for block in model.written:
            lines += block_lines(block, model)
    for load in model.loads:
        lines += ["[[load]]", f'block = "{load.block}"', f"force = {numbers(load.force)}", f"moment = {numbers(load.moment)}"]
        lines += ([f"at = {numbers(load.at)}"] if load.at is not None else []) + [""]
    for number, tie in enumerate(model.ties):
        area = 1e-4 if tie.most is None else max(1e-9, 1e-7 * tie.most)  # m2
        lines += ["[[tie]]", f'name = "tie {number}"', f"from = {numbers(tie.points[0])}", f"to = {numbers(tie.points[1])}", f"area = {area!r}"]
        lines += ([f"yield = {tie.most / area!r}"] if tie.most is not None else []) + (["compression = true"] if tie.compression else []) + [""]
    path.write_text("\n".join(lines))


def options(model):
    """Options of `voussoir limit` for the model."""
    words = {0.0: "x", 90.0: "y", 180.0: "-x", -180.0: "-x", -90.0: "-y"}
    out = ["--direction=" + words.get(model.direction, repr(model.direction))]
    return out + ([] if model.plane else ["--facets", str(model.facets), "--cone", model.cone])
