import type { TiledMap, TiledObject, TiledProperty } from './map.ts';

/** Characters that XML cannot hold, not even as references. */
const IMPOSSIBLE = /[^\t\n\r\u0020-\ud7ff\ue000-\ufffd\u{10000}-\u{10ffff}]/gu;

const REFERENCES: Readonly<Record<string, string>> = {
  '<': '&lt;',
  '>': '&gt;',
  '&': '&amp;',
  '"': '&quot;',
  '\n': '&#10;',
  '\r': '&#13;',
  '\t': '&#9;',
};

const escaped = (text: string): string => text.replace(IMPOSSIBLE, '\ufffd').replace(/[<>&"\n\r\t]/g, (sign) => REFERENCES[sign]);

const attributes = (values: Readonly<Record<string, string | number | boolean>>): string =>
  Object.entries(values)
    .map(([key, value]) => ` ${key}="${escaped(String(value))}"`)
    .join('');

const row = ({ name, type, value }: TiledProperty, indent: string): string =>
  `${indent} <property${attributes({ name, ...(type === 'string' ? {} : { type }), value })}/>\n`;

const formatProperties = (properties: readonly TiledProperty[] = [], indent: string): string =>
  properties.length === 0
    ? ''
    : `${indent}<properties>\n${properties.map((one) => row(one, indent)).join('')}${indent}</properties>\n`;

function formatObject(object: TiledObject): string {
  const { id, name, type, x, y, width, height, ellipse, properties } = object;
  const size: Record<string, number> = ellipse === true ? { width, height } : {};
  const shape = ellipse === true ? 'ellipse' : 'point';
  const inner = `${formatProperties(properties, '   ')}   <${shape}/>\n`;
  return `  <object${attributes({ id, name, type, x, y, ...size })}>\n${inner}  </object>\n`;
}

/**
 * Writes a Tiled map as an XML file (`.tmx`). A character that XML cannot hold becomes U+FFFD.
 *
 * @param map - the map
 * @returns the text of the file
 */
export function formatTmx(map: TiledMap): string {
  const { version, tiledversion, orientation, renderorder, width, height, tilewidth, tileheight } = map;
  const { backgroundcolor, nextlayerid, nextobjectid, properties, layers } = map;
  const head = { version, tiledversion, class: map.class, orientation, renderorder, width, height, tilewidth, tileheight };
  const all = attributes({ ...head, infinite: 0, backgroundcolor, nextlayerid, nextobjectid });
  const groups = layers.map(({ id, name, color, draworder, objects }) => {
    const inner = objects.map(formatObject).join('');
    const layer = `<objectgroup${attributes({ id, name, color, draworder })}`;
    return inner === '' ? ` ${layer}/>\n` : ` ${layer}>\n${inner} </objectgroup>\n`;
  });
  return `<?xml version="1.0" encoding="UTF-8"?>\n<map${all}>\n${formatProperties(properties, ' ')}${groups.join('')}</map>\n`;
}
