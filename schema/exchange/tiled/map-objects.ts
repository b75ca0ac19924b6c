import { type Finding, formatValue, MAX_FINDINGS, type Path, quote, toPointer } from '../../basics/index.ts';
import { isObject, type Json } from '../../json/index.ts';

/** What an object of a map is drawn as. */
export type Shape = 'rectangle' | 'ellipse' | 'point' | 'polygon' | 'polyline' | 'capsule' | 'text' | 'tile' | 'template';

/** A custom property, with its path in the map. */
export interface ReadProperty {
  readonly name: string;
  readonly value: unknown;
  /** Its type as the map says it; `string` where it says none. */
  readonly type: string;
  readonly path: Path;
}

/** An object of a map. Its place is that of the map: offsets of its layers are added. */
export interface ReadObject {
  readonly path: Path;
  /** Its number in the map; null if it has none. */
  readonly id: number | null;
  /** What to call it: `object 7 "rock"`. */
  readonly title: string;
  /** Its class; '' if it has none. */
  readonly type: string;
  /** Name and class of its layer. */
  readonly layer: readonly string[];
  readonly shape: Shape;
  /** Whether Tiled shows it; its layer may still be hidden. */
  readonly isVisible: boolean;
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
  readonly rotation: number;
  readonly properties: ReadonlyMap<string, ReadProperty>;
}

interface Around {
  readonly x: number;
  readonly y: number;
}

const SHAPES: readonly (readonly [key: string, shape: Shape])[] = [
  ['template', 'template'],
  ['gid', 'tile'],
  ['ellipse', 'ellipse'],
  ['point', 'point'],
  ['capsule', 'capsule'],
  ['polygon', 'polygon'],
  ['polyline', 'polyline'],
  ['text', 'text'],
];

const LAYERS: Readonly<Record<string, string>> = { tilelayer: 'a layer of tiles', imagelayer: 'a layer with a picture' };

const textOf = (value: unknown): string => (typeof value === 'string' ? value : '');

const numberOf = (value: unknown): number => (typeof value === 'number' ? value : 0);

/** Reads layers, objects and properties of a map in Tiled's JSON map format. */
export class MapReader {
  readonly findings: Finding[] = [];
  readonly notes: string[] = [];
  readonly objects: ReadObject[] = [];
  private readonly read = new Map<string, ReadProperty>();

  find(code: Finding['code'], path: Path, message: string, hint: string): void {
    if (this.findings.length < MAX_FINDINGS) this.findings.push({ code, message, hint, path, part: 'value' });
  }

  /** The custom properties of the map or an object; Tiled before 1.2 wrote an object in place of the list. */
  properties(owner: Json, path: Path, title: string): ReadonlyMap<string, ReadProperty> {
    const { properties } = owner;
    const at = [...path, 'properties'];
    const read = new Map<string, ReadProperty>();
    if (Array.isArray(properties)) {
      for (const [i, one] of properties.entries()) {
        if (!isObject(one) || typeof one.name !== 'string') {
          const message = `${title}: expected a property with name and value, found ${formatValue(one)}`;
          this.find('wrong-type', [...at, i], message, 'Save the map again in Tiled.');
        } else {
          const type = typeof one.type === 'string' ? one.type : 'string';
          read.set(one.name, { name: one.name, value: one.value, type, path: [...at, i, 'value'] });
        }
      }
    } else if (isObject(properties)) {
      const types = isObject(owner.propertytypes) ? owner.propertytypes : {};
      for (const [name, value] of Object.entries(properties)) {
        read.set(name, { name, value, type: textOf(types[name]) || 'string', path: [...at, name] });
      }
    } else if (properties !== undefined) {
      this.find(
        'wrong-type',
        at,
        `${title}: expected a list of properties, found ${formatValue(properties)}`,
        'Save the map again in Tiled.',
      );
    }
    for (const property of read.values()) this.read.set(toPointer(property.path), property);
    return read;
  }

  /** The property whose value is at a path; undefined if something else is there. */
  propertyAt(path: Path): ReadProperty | undefined {
    return this.read.get(toPointer(path));
  }

  /** Reads the layers of a map or of a group. The text bounds how deeply groups are nested. */
  layers(owner: Json, path: Path, around: Around): void {
    const { layers } = owner;
    const at = [...path, 'layers'];
    if (!Array.isArray(layers)) {
      this.find('wrong-type', path, `expected a list "layers", found ${formatValue(layers)}`, 'Save the map again in Tiled.');
      return;
    }
    for (const [i, layer] of layers.entries()) {
      if (this.findings.length >= MAX_FINDINGS) return;
      if (isObject(layer)) this.layer(layer, [...at, i], around);
      else this.find('wrong-type', [...at, i], `expected a layer, found ${formatValue(layer)}`, 'Save the map again in Tiled.');
    }
  }

  private layer(layer: Json, path: Path, around: Around): void {
    const isGroup = layer.type === 'group';
    const name = `the ${isGroup ? 'group' : 'layer'} ${quote(textOf(layer.name))}`;
    const offset = { x: around.x + numberOf(layer.offsetx), y: around.y + numberOf(layer.offsety) };
    if (isGroup || layer.type === 'objectgroup') {
      if (layer.visible === false) this.noteHidden(name);
      if (isGroup) this.layers(layer, path, offset);
      else this.readObjects(layer, path, offset);
    } else {
      const what = LAYERS[textOf(layer.type)] ?? `of the unknown type ${quote(textOf(layer.type))}`;
      this.notes.push(`ignored ${name}: it is ${what}`);
    }
  }

  /** What Tiled hides is part of the level, as the game has nothing that is hidden. */
  noteHidden(title: string): void {
    this.notes.push(`${title} is hidden, and was read all the same`);
  }

  private readObjects(layer: Json, path: Path, around: Around): void {
    const { objects } = layer;
    const at = [...path, 'objects'];
    if (!Array.isArray(objects)) {
      this.find('wrong-type', at, `expected a list "objects", found ${formatValue(objects)}`, 'Save the map again in Tiled.');
      return;
    }
    const names = [textOf(layer.class), textOf(layer.name)];
    for (const [i, object] of objects.entries()) {
      if (this.findings.length >= MAX_FINDINGS) return;
      if (isObject(object)) this.readObject(object, [...at, i], names, around);
      else
        this.find('wrong-type', [...at, i], `expected an object, found ${formatValue(object)}`, 'Save the map again in Tiled.');
    }
  }

  private readObject(object: Json, path: Path, layer: readonly string[], around: Around): void {
    const id = typeof object.id === 'number' ? object.id : null;
    const name = textOf(object.name);
    const title = `object ${id ?? Number(path.at(-1)) + 1}${name === '' ? '' : ` ${quote(name)}`}`;
    const number = (key: string, isRequired: boolean): number => {
      const value = object[key] ?? (isRequired ? undefined : 0);
      if (typeof value === 'number') return value;
      const found = value === undefined ? 'nothing' : formatValue(value);
      const where = object[key] === undefined ? path : [...path, key];
      this.find('wrong-type', where, `${title}: expected a number as ${key}, found ${found}`, 'Save the map again in Tiled.');
      return 0;
    };
    const drawn = SHAPES.find(([key]) => object[key] !== undefined && object[key] !== false)?.[1] ?? 'rectangle';
    const isTemplate = drawn === 'template';
    const [x, y] = [number('x', !isTemplate), number('y', !isTemplate)];
    const [width, height, rotation] = [number('width', false), number('height', false), number('rotation', false)];
    // a click with the tool for rectangles or ellipses makes an object without size, which Tiled draws as a point
    const isClick = (drawn === 'rectangle' || drawn === 'ellipse') && width === 0 && height === 0;
    this.objects.push({
      path,
      id,
      title,
      // Tiled 1.9 wrote `class`
      type: textOf(object.type) || textOf(object.class),
      layer,
      shape: isClick ? 'point' : drawn,
      isVisible: object.visible !== false,
      x: x + around.x,
      y: y + around.y,
      width,
      height,
      rotation,
      properties: this.properties(object, path, title),
    });
  }
}
