import { type Finding, formatValue, quote } from '../basics/index.ts';

type Json = Readonly<Record<string, unknown>>;

const isObject = (value: unknown): value is Json => typeof value === 'object' && value !== null && !Array.isArray(value);

/** Maps of a world that a message names. */
const MOST_NAMED = 5;

const DRAWN = 'circles and points whose class is a kind of object';

/** What a file of another editor is, and what to do with it. */
interface OtherFile {
  readonly found: string;
  readonly hint: string;
}

const PROJECT: OtherFile = { found: 'a project of Tiled', hint: 'It has no objects: import the maps (.tmj, .tmx) themselves.' };

/** Files that Tiled writes beside maps, by the type that their JSON says, and by their element in XML. */
export const BESIDE_MAPS: Readonly<Record<string, OtherFile>> = {
  tileset: { found: 'a tileset of Tiled', hint: 'A level is made of the objects of a map: import the map (.tmj, .tmx).' },
  template: {
    found: 'a template of Tiled',
    hint: 'Choose Detach in the context menu of its instances in the map, save the map and import that.',
  },
};

function world({ maps }: Json): OtherFile {
  const names = (Array.isArray(maps) ? maps : []).flatMap((map) =>
    isObject(map) && typeof map.fileName === 'string' ? [quote(map.fileName)] : [],
  );
  const shown = names.slice(0, MOST_NAMED).join(', ');
  const more = names.length > MOST_NAMED ? ` and ${names.length - MOST_NAMED} more` : '';
  return names.length === 0
    ? { found: 'a world of Tiled, which names its maps by a pattern', hint: 'Import each of its maps by itself.' }
    : { found: `a world of Tiled, which has the maps ${shown}${more}`, hint: 'Import each of its maps by itself.' };
}

function ldtk(header: Json): OtherFile {
  const found = `${formatValue(header.fileType ?? 'LDtk').replace(/^the text /, '')}, a file of LDtk`;
  return {
    found,
    hint: `Turn on Tiled export in the project's settings, open the .tmx in Tiled, draw ${DRAWN} in place of its rectangles, and import that.`,
  };
}

function otherFile(value: unknown): OtherFile | null {
  if (!isObject(value)) return null;
  const header = value.__header__;
  if (isObject(header) && (header.app === 'LDtk' || String(header.fileType).startsWith('LDtk'))) return ldtk(header);
  if (value.type === 'world' || (Array.isArray(value.maps) && value.onlyShowAdjacentMaps !== undefined)) return world(value);
  if (typeof value.type === 'string' && Object.hasOwn(BESIDE_MAPS, value.type)) return BESIDE_MAPS[value.type];
  return Array.isArray(value.folders) && value.automappingRulesFile !== undefined ? PROJECT : null;
}

/**
 * Recognizes files of other level editors that hold no level that could be read.
 *
 * @param value - the JSON value of the file
 * @param expected - what was expected, in words
 * @returns what it is and what to do; null if it is none of them
 */
export function otherEditor(value: unknown, expected: string): Finding | null {
  const other = otherFile(value);
  if (other === null) return null;
  const { found, hint } = other;
  return { code: 'not-a-level', message: `expected ${expected}, found ${found}`, hint, path: [], part: 'value' };
}
