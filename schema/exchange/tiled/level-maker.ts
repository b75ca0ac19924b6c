import { closestName, fieldsOf, KINDS, OBJECT_KINDS, type ObjectKind, type Path, quote } from '../../basics/index.ts';
import { readJson } from '../../json/index.ts';
import { EXACT, PARTNER, POINT_KINDS } from './map.ts';
import type { MapReader, ReadObject, ReadProperty } from './map-objects.ts';

/** How far an exact place may be from the place in the map: rounding is less, and what a person moves is more; px. */
const ROUNDING = 1e-4;

/** How much width and height of a circle may differ: Tiled writes some formats with few digits. */
const ROUNDNESS = 1e-5;

/** A name without case, spaces and signs. */
const plain = (name: string): string => name.toLowerCase().replace(/[^a-z0-9]/g, '');

export interface Meaning {
  readonly kind: ObjectKind;
  /** The flag that the class stands for, as in `hot asteroid`. */
  readonly flag: string | null;
}

/** What classes of objects, and names of layers, mean. */
const CLASSES: ReadonlyMap<string, Meaning> = new Map(
  OBJECT_KINDS.flatMap((kind) => {
    const { list, one, many, variant } = KINDS[kind];
    const names = [kind, one, many, ...(list === null ? [] : [list])].map((name) => [plain(name), { kind, flag: null }] as const);
    const varied = variant === undefined ? [] : [variant.one, variant.many];
    return [...names, ...varied.map((name) => [plain(name), { kind, flag: variant?.flag ?? null }] as const)];
  }),
);

const NAMES_OF_THE_ORIGINAL: ReadonlyMap<string, ObjectKind> = new Map(
  OBJECT_KINDS.flatMap((kind) => {
    const { original } = KINDS[kind];
    if (original === null) return [];
    const one = original.key.replace(/ies$/, 'y').replace(/s$/, '');
    return [original.key, one].map((name) => [plain(name), kind] as const);
  }),
);

/** An object of the level, and where its parts are in the map. */
export interface Made {
  readonly kind: ObjectKind;
  readonly values: Record<string, unknown>;
  readonly source: ReadObject;
  /** The paths of its fields in the map. */
  readonly paths: Map<string, Path>;
}

/** Puts the objects of a map into a level. */
export class LevelMaker {
  readonly reader: MapReader;
  readonly made: Made[] = [];
  private readonly offset: readonly number[];

  constructor(reader: MapReader, offset: readonly number[]) {
    this.reader = reader;
    this.offset = offset;
  }

  /** What an object is; null if it is not for the level, or if that is reported. */
  meaningOf(object: ReadObject): Meaning | null {
    // its class and its shape are in the file of the template
    if (object.shape === 'template') {
      const message = `${object.title}: expected an object of its own, found an instance of a template, which is in another file`;
      const hint = 'Choose Detach in its context menu, or export the map with "Detach templates".';
      this.reader.find('wrong-shape', object.path, message, hint);
      return null;
    }
    const known = CLASSES.get(plain(object.type));
    if (known !== undefined) return known;
    if (object.type === '') {
      const meant = object.layer.map((name) => CLASSES.get(plain(name))).find((meaning) => meaning !== undefined);
      if (meant !== undefined && object.shape !== 'text') return meant;
      if (object.shape === 'text') {
        this.reader.notes.push(`ignored ${object.title}: it is a text`);
        return null;
      }
    }
    const classes = OBJECT_KINDS.join(', ');
    const meant = NAMES_OF_THE_ORIGINAL.get(plain(object.type)) ?? closestName(object.type, OBJECT_KINDS);
    const found = object.type === '' ? 'found none' : `found ${quote(object.type)}`;
    const guess = object.type !== '' && meant !== null ? `: did you mean "${meant}"?` : '';
    const message = `${object.title}: expected a class that is a kind of object, ${found}${guess}`;
    const hint = `Set its Class in Tiled to one of ${classes}, or move what is not part of the level to another map.`;
    this.reader.find('unknown-class', object.path, message, hint);
    return null;
  }

  /** The centre of an object, and its radius if it is a circle; null if it has another shape, which is reported. */
  discOf(object: ReadObject, kind: ObjectKind): { readonly centre: readonly number[]; readonly radius: number | null } | null {
    const { title, path, shape, x, y, width, height, rotation } = object;
    const { one, radius } = KINDS[kind];
    const refuse = (message: string, hint: string): null => {
      this.reader.find('wrong-shape', path, `${title}: ${message}`, hint);
      return null;
    };
    const isPoint = POINT_KINDS.includes(kind);
    const usual = radius === null ? 0 : KINDS[kind].fields[radius].default;
    if (shape === 'point' && usual === undefined && !object.properties.has('radius')) {
      return refuse(
        `expected a circle for the ${one}, found a point`,
        'Draw it with Insert Ellipse, with Shift held, or give it a property radius.',
      );
    }
    if (shape === 'point') return { centre: this.exact(object, [x, y]), radius: null };
    const isBox = shape === 'rectangle' && radius === null;
    if (shape !== 'ellipse' && !isBox) {
      const wanted = isPoint ? 'a point' : 'a circle';
      const tool = isPoint ? 'Insert Point' : 'Insert Ellipse, with Shift held';
      return refuse(`expected ${wanted} for the ${one}, found a ${shape}`, `Draw it with ${tool}.`);
    }
    if (rotation % 360 !== 0) {
      return refuse(
        `expected the rotation 0, found ${rotation}`,
        'Set its Rotation to 0: Tiled turns objects about their upper left corner.',
      );
    }
    if (!isBox && radius !== null && Math.abs(width - height) > ROUNDNESS * Math.max(width, height)) {
      return refuse(`expected a circle, found an ellipse of ${width} x ${height} px`, 'Make its Width and Height equal.');
    }
    return { centre: this.exact(object, [x + width / 2, y + height / 2]), radius: radius === null ? null : width / 2 };
  }

  /** A place in the level; its last bits are in properties of the object where the map has rounded them away. */
  private exact({ properties }: ReadObject, place: readonly number[]): readonly number[] {
    return place.map((at, i) => {
      const value = at - this.offset[i];
      const exact = properties.get(EXACT[i])?.value;
      return typeof exact === 'number' && Math.abs(exact - value) <= ROUNDING ? exact : value;
    });
  }

  /** Makes an object of the level of one object of the map, or of two that lead to each other. */
  make(meaning: Meaning, object: ReadObject, partner: ReadObject | null): void {
    const { kind, flag } = meaning;
    const { places, radius } = KINDS[kind];
    const disc = this.discOf(object, kind);
    const second = partner === null ? null : this.discOf(partner, kind);
    if (disc === null || (partner !== null && second === null)) return;
    const values: Record<string, unknown> = {};
    const paths = new Map<string, Path>();
    const used = new Set<string>([...EXACT, ...(places.length > 1 ? [PARTNER] : [])]);
    const take = (name: string): void => {
      const property = object.properties.get(name);
      used.add(name);
      if (property === undefined) return;
      values[name] = property.value;
      paths.set(name, property.path);
    };
    if (KINDS[kind].list !== null) take('id');
    const discs = [disc, ...(second === null ? [] : [second])];
    for (const [i, { centre }] of discs.entries()) for (const [j, name] of places[i].entries()) values[name] = centre[j];
    for (const [name] of fieldsOf(kind)) if (!places.flat().includes(name)) take(name);
    if (flag !== null) values[flag] = true;
    if (radius !== null) this.takeRadius(object, disc.radius, values, paths);
    if (second !== null && second.radius !== null && disc.radius !== null && second.radius !== disc.radius && partner !== null) {
      const message = `${partner.title}: expected the radius ${disc.radius} of ${object.title}, the other mouth, found ${second.radius}`;
      this.reader.find('wrong-shape', partner.path, message, 'Make both mouths the same size.');
    }
    for (const property of object.properties.values()) {
      if (property.name.startsWith('x-')) values[property.name] = ownValue(property);
      else if (!used.has(property.name))
        this.reader.notes.push(`ignored the property ${quote(property.name)} of ${object.title}`);
    }
    // what is the default anyway stays out of the file
    for (const [name, field] of fieldsOf(kind))
      if (field.default !== undefined && values[name] === field.default) delete values[name];
    this.made.push({ kind, values, source: object, paths });
  }

  /** A circle says its radius itself; a point has a property for it. */
  private takeRadius(object: ReadObject, drawn: number | null, values: Record<string, unknown>, paths: Map<string, Path>): void {
    if (drawn !== null) {
      const written = values.radius;
      if (written !== undefined && written !== drawn) {
        this.reader.notes.push(`ignored the property "radius" of ${object.title}: it is a circle of radius ${drawn}`);
      }
      values.radius = drawn;
      paths.set('radius', [...object.path, 'width']);
    }
  }
}

/** The value of an x- key: what a property says as JSON, or else its text. */
export function ownValue({ value }: ReadProperty): unknown {
  if (typeof value !== 'string') return value;
  const json = readJson(value, 'refuse');
  return json.ok && json.findings.length === 0 ? json.value : value;
}
