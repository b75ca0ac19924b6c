import { type Finding, MAX_FILE_SIZE, type Path, type Problem, toPointer } from '../../basics/index.ts';
import { createPlaceFinder, decodeUtf8, isUtf16, type Locator, mergeMarkers, readJson, xmlRoot } from '../../json/index.ts';
import { readXml, type XmlElement } from './xml.ts';

/** Tells whether a file is a map in XML. */
export function isTmx(source: Uint8Array | string): boolean {
  // most files are JSON, and need not be decoded for this
  if (source.length > MAX_FILE_SIZE || source[0] === 0x7b) return false;
  return xmlRoot(typeof source === 'string' ? source : decodeUtf8(source).text) === 'map';
}

const LAYERS: Readonly<Record<string, string>> = {
  layer: 'tilelayer',
  imagelayer: 'imagelayer',
  group: 'group',
  objectgroup: 'objectgroup',
};

const SHAPES = ['ellipse', 'point', 'capsule', 'polygon', 'polyline', 'text'];

const NUMBERS = ['id', 'gid', 'x', 'y', 'width', 'height', 'rotation', 'offsetx', 'offsety', 'tilewidth', 'tileheight'];

/** A number as it is written; any other text stays a text, so that it is reported where a number is expected. */
function asNumber(text: string): number | string {
  const value = /^[-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?$/i.test(text) ? Number(text) : Number.NaN;
  return Number.isFinite(value) ? value : text;
}

/** Turns elements into values of Tiled's JSON map format, and notes where each one comes from. */
class Converter {
  readonly offsets = new Map<string, number>();

  private attributes(element: XmlElement, path: Path): Record<string, unknown> {
    this.offsets.set(toPointer(path), element.at);
    const value: Record<string, unknown> = {};
    for (const [key, attribute] of element.attributes) {
      this.offsets.set(toPointer([...path, key]), attribute.at);
      value[key] = NUMBERS.includes(key) ? asNumber(attribute.value) : attribute.value;
      if (key === 'visible') value[key] = !['0', 'false'].includes(attribute.value);
    }
    return value;
  }

  private properties(element: XmlElement, path: Path): unknown[] | undefined {
    const list = element.children.find(({ name }) => name === 'properties');
    return list?.children.map((property, i) => {
      const at = [...path, 'properties', i];
      const { type, ...rest } = this.attributes(property, at);
      if (rest.value === undefined) this.offsets.set(toPointer([...at, 'value']), property.at);
      const text = (rest.value ?? property.text) as string;
      return { ...rest, type, value: this.value(String(type ?? 'string'), text) };
    });
  }

  private value(type: string, text: string): unknown {
    if (type === 'int' || type === 'float' || type === 'object') return asNumber(text);
    return type === 'bool' && (text === 'true' || text === 'false') ? text === 'true' : text;
  }

  private object(element: XmlElement, path: Path): unknown {
    const drawn = element.children.filter(({ name }) => SHAPES.includes(name)).map(({ name }) => [name, true]);
    return { ...this.attributes(element, path), ...Object.fromEntries(drawn), properties: this.properties(element, path) };
  }

  /** A layer or a group; elements are nested no deeper than the reader of XML allows. */
  private layer(element: XmlElement, path: Path): unknown {
    const value = { ...this.attributes(element, path), type: LAYERS[element.name], properties: this.properties(element, path) };
    if (element.name === 'group') return { ...value, layers: this.layers(element, path) };
    if (element.name !== 'objectgroup') return value;
    const objects = element.children.filter(({ name }) => name === 'object');
    return { ...value, objects: objects.map((object, i) => this.object(object, [...path, 'objects', i])) };
  }

  private layers(element: XmlElement, path: Path): unknown[] {
    const layers = element.children.filter(({ name }) => Object.hasOwn(LAYERS, name));
    return layers.map((layer, i) => this.layer(layer, [...path, 'layers', i]));
  }

  map(element: XmlElement): unknown {
    const tilesets = element.children.filter(({ name }) => name === 'tileset').map(() => ({}));
    const properties = this.properties(element, []);
    return { ...this.attributes(element, []), type: 'map', properties, layers: this.layers(element, []), tilesets };
  }
}

function wholeFile(
  text: string,
  message: string,
  hint: string,
  at: number,
  code: 'unsupported-map' | 'merge-markers' = 'unsupported-map',
): MapSource {
  const place = createPlaceFinder(text)(at);
  const problem: Problem = { code, severity: 'error', message, hint, pointer: '', ...place };
  return { ok: false, problems: [problem], text };
}

/** Reads a map in XML. */
function readTmx(source: Uint8Array | string): MapSource {
  // it says what is wrong with the size or the encoding
  if (source.length > MAX_FILE_SIZE) return readJson(source, 'skip');
  const { text: decoded, bad } = typeof source === 'string' ? { text: source, bad: null } : decodeUtf8(source);
  const text = decoded.replace(/^\ufeff/, '');
  if (bad !== null && typeof source !== 'string') {
    const message = `the byte at offset ${bad.at} is not UTF-8${isUtf16(source) ? ': the file looks like UTF-16' : ''}`;
    return wholeFile(text, message, 'Save the map again in Tiled.', bad.offset);
  }
  const xml = readXml(text);
  const markers = xml.ok ? null : mergeMarkers(text, xml.at);
  if (markers !== null) return wholeFile(text, markers.message, markers.hint, markers.offset, 'merge-markers');
  if (!xml.ok) return wholeFile(text, `the text is not valid XML: ${xml.message}`, 'Save the map again in Tiled.', xml.at);
  const converter = new Converter();
  const value = converter.map(xml.root);
  const locator: Locator = {
    offsetOf(pointer) {
      let at = pointer;
      while (at !== '' && !converter.offsets.has(at)) at = at.slice(0, at.lastIndexOf('/'));
      return converter.offsets.get(at) ?? 0;
    },
    placeAt: createPlaceFinder(text),
  };
  return { ok: true, text, value, locator, findings: [] };
}

/** A map as a value in Tiled's JSON map format, whatever the format of the file. */
type MapSource =
  | {
      readonly ok: true;
      readonly text: string;
      readonly value: unknown;
      readonly locator: Locator;
      readonly findings: readonly Finding[];
    }
  | { readonly ok: false; readonly problems: Problem[]; readonly text: string };

/** Reads the text of a map: JSON (.tmj, .json) or XML (.tmx). */
export const readMapSource = (source: Uint8Array | string): MapSource =>
  isTmx(source) ? readTmx(source) : readJson(source, 'skip');
