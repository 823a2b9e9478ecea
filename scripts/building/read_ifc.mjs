// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
// Reads an IFC file (2x3, 4, 4.3) and writes what scripts/import needs as JSON: for each element of a building its name, storey, layers of
// material and surface, in metres with z upwards. usage: node read_ifc.mjs FILE.ifc >ELEMENTS.json
import { readFileSync } from "node:fs";
import * as Ifc from "web-ifc";

/** Elements by their class. Surfaces are those of walls and slabs; of the others there is a name alone. */
const kClasses = {
  wall: ["IFCWALL", "IFCWALLSTANDARDCASE", "IFCWALLELEMENTEDCASE"], slab: ["IFCSLAB", "IFCSLABSTANDARDCASE", "IFCSLABELEMENTEDCASE"], roof: ["IFCROOF"],
  beam: ["IFCBEAM", "IFCBEAMSTANDARDCASE"], column: ["IFCCOLUMN", "IFCCOLUMNSTANDARDCASE"], member: ["IFCMEMBER", "IFCMEMBERSTANDARDCASE"],
  plate: ["IFCPLATE", "IFCPLATESTANDARDCASE"], footing: ["IFCFOOTING"], stair: ["IFCSTAIR", "IFCSTAIRFLIGHT"], ramp: ["IFCRAMP", "IFCRAMPFLIGHT"], railing: ["IFCRAILING"],
  covering: ["IFCCOVERING"], "curtain wall": ["IFCCURTAINWALL"], proxy: ["IFCBUILDINGELEMENTPROXY"], door: ["IFCDOOR", "IFCDOORSTANDARDCASE"], window: ["IFCWINDOW", "IFCWINDOWSTANDARDCASE"],
};

const text = (value) => (typeof value?.value === "string" ? value.value : "");
const number = (value) => (typeof value?.value === "number" ? value.value : 0);

class Reader {
  constructor(api, model) {
    Object.assign(this, { api, model, storeyOf: new Map(), openingsOf: new Map(), materialOf: new Map(), typeOf: new Map() });
    this.metre = this.#lengthUnit();
    for (const r of this.#all("IFCRELCONTAINEDINSPATIALSTRUCTURE")) for (const e of r.RelatedElements) this.storeyOf.set(e.value, r.RelatingStructure.value);
    for (const r of this.#all("IFCRELAGGREGATES")) for (const e of r.RelatedObjects) if (!this.storeyOf.has(e.value)) this.storeyOf.set(e.value, r.RelatingObject.value);
    for (const r of this.#all("IFCRELVOIDSELEMENT")) this.#push(this.openingsOf, r.RelatingBuildingElement.value, r.RelatedOpeningElement.value);
    for (const r of this.#all("IFCRELDEFINESBYTYPE")) for (const e of r.RelatedObjects) this.typeOf.set(e.value, r.RelatingType.value);
    for (const r of this.#all("IFCRELASSOCIATESMATERIAL")) for (const e of r.RelatedObjects) this.materialOf.set(e.value, r.RelatingMaterial.value);
  }
  #push(map, key, value) { map.set(key, [...(map.get(key) ?? []), value]); }
  ids(type) { return Ifc[type] === undefined ? [] : [...this.api.GetLineIDsWithType(this.model, Ifc[type])]; }
  line(id) { return this.api.GetLine(this.model, id); }
  #all(type) { return this.ids(type).map((id) => this.line(id)); }

  /** Metres in the file's unit of length: that of the unit assignment, as feet are given by a factor of a metric unit. */
  #lengthUnit() {
    const prefixes = { MILLI: 1e-3, CENTI: 1e-2, DECI: 1e-1, DECA: 10, HECTO: 100, KILO: 1e3 };
    for (const assignment of this.#all("IFCUNITASSIGNMENT"))
      for (const unit of assignment.Units.map((u) => this.line(u.value))) {
        if (text(unit.UnitType) !== "LENGTHUNIT") continue;
        if (!unit.ConversionFactor) return prefixes[text(unit.Prefix)] ?? 1;
        const factor = this.line(unit.ConversionFactor.value), base = this.line(factor.UnitComponent.value);
        return number(factor.ValueComponent) * (prefixes[text(base.Prefix)] ?? 1);
      }
    return 1;
  }

  /** The surface of an element: corners, three numbers each, and triangles. */
  surface(id) {
    const corners = [], triangles = [];
    let mesh;
    try {
      mesh = this.api.GetFlatMesh(this.model, id);
    } catch {
      return { corners, triangles };
    }
    for (let g = 0; g < mesh.geometries.size(); ++g) {
      const placed = mesh.geometries.get(g), geometry = this.api.GetGeometry(this.model, placed.geometryExpressID), m = placed.flatTransformation;
      const points = this.api.GetVertexArray(geometry.GetVertexData(), geometry.GetVertexDataSize()), first = corners.length / 3;
      const index = this.api.GetIndexArray(geometry.GetIndexData(), geometry.GetIndexDataSize());
      for (let i = 0; i < points.length; i += 6) {
        const at = [0, 1, 2].map((k) => m[k] * points[i] + m[4 + k] * points[i + 1] + m[8 + k] * points[i + 2] + m[12 + k]);
        corners.push(at[0], -at[2], at[1]); // web-ifc has y upwards
      }
      for (const i of index) triangles.push(first + i);
      geometry.delete();
    }
    return { corners, triangles };
  }

  /** Storeys above an element, from the nearest: a part of a stair is in the stair, which is in a storey. */
  storey(id) {
    for (let at = this.storeyOf.get(id), steps = 0; at !== undefined && steps < 20; at = this.storeyOf.get(at), ++steps) {
      const line = this.line(at);
      if (line.constructor.name === "IfcBuildingStorey") return text(line.Name) || text(line.LongName);
    }
    return "";
  }

  /** Layers of an element, from one face to the other: [{name, thickness in m}]; one of thickness 0 where the file names a material alone. */
  layers(id) {
    const rows = this.#layersOf(this.materialOf.get(id));
    if (rows.length > 0) return rows;
    return this.#layersOf(this.materialOf.get(this.typeOf.get(id)));
  }
  #layersOf(id) {
    if (id === undefined) return [];
    const m = this.line(id);
    if (m.ForLayerSet) return this.#layersOf(m.ForLayerSet.value);
    if (m.MaterialLayers) return m.MaterialLayers.map((l) => this.line(l.value)).map((l) => ({ name: l.Material ? text(this.line(l.Material.value).Name) : "", thickness: this.metre * number(l.LayerThickness) }));
    if (m.Materials) return m.Materials.map((x) => ({ name: text(this.line(x.value).Name), thickness: 0 }));
    return text(m.Name) ? [{ name: text(m.Name), thickness: 0 }] : [];
  }

  element(id, kind) {
    const line = this.line(id);
    if (kind !== "wall" && kind !== "slab") return { id: text(line.GlobalId), kind, type: "", name: text(line.Name), storey: this.storey(id), layers: [], openings: [], corners: [], triangles: [] };
    const openings = (this.openingsOf.get(id) ?? []).map((o) => ({ name: text(this.line(o).Name), ...this.surface(o) }));
    return { id: text(line.GlobalId), kind, type: text(line.PredefinedType), name: text(line.Name), storey: this.storey(id), layers: this.layers(id), openings, ...this.surface(id) };
  }
}

async function main(file) {
  const api = new Ifc.IfcAPI();
  await api.Init();
  api.SetLogLevel(Ifc.LogLevel.LOG_LEVEL_OFF);
  const bytes = readFileSync(file);
  if (!bytes.subarray(-2000).includes("END-ISO-10303-21")) throw new Error("it does not end as an IFC file does; it may be cut off");
  const model = api.OpenModel(new Uint8Array(bytes), { COORDINATE_TO_ORIGIN: false });
  if (model < 0 || api.GetModelSchema(model) === "") throw new Error(`${file} is no IFC file that can be read`);
  const reader = new Reader(api, model);
  const elements = Object.entries(kClasses).flatMap(([kind, types]) => types.flatMap((type) => reader.ids(type)).map((id) => reader.element(id, kind)));
  process.stdout.write(JSON.stringify({ schema: api.GetModelSchema(model), elements }));
}

main(process.argv[2]).catch((error) => {
  process.stderr.write(`${error.message ?? error}\n`);
  process.exitCode = 1;
});
