import { readFileSync } from 'node:fs';
import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import {
  exportTiled,
  formatLevel,
  formatTiled,
  formatTmx,
  importOriginal,
  importTiled,
  isTiledMap,
  type LevelFile,
  LISTED_KINDS,
  listOf,
  readLevel,
  resolveLevel,
  type TiledMap,
  withIds,
} from '../../schema/index.ts';
import { arbitraryFile } from './arbitrary-file.ts';

const fixture = (name: string): Uint8Array => readFileSync(new URL(`./fixtures/tiled/${name}`, import.meta.url));

function imported(source: Uint8Array | string, slug = 'a-map') {
  const reading = importTiled(source, { slug });
  if (!reading.ok) throw new Error(JSON.stringify(reading.problems, null, 1));
  return { ...reading.levels[0], notes: reading.notes };
}

function problems(source: Uint8Array | string) {
  const reading = importTiled(source, { slug: 'a-map' });
  if (reading.ok) throw new Error('was imported');
  for (const { hint } of reading.problems) expect(hint).toMatch(/^[A-Z].*\.$/);
  return reading.problems;
}

/** The level with ids, and the keys of its own, which resolving drops. */
const complete = (file: LevelFile): readonly unknown[] => [
  resolveLevel(withIds(file)),
  Object.entries(file).filter(([key]) => key.startsWith('x-') || key === 'conflicts' || key === 'allow'),
  LISTED_KINDS.map((kind) =>
    (file[listOf(kind)] ?? []).map((object) => Object.entries(object).filter(([key]) => key.startsWith('x-'))),
  ),
];

/** As `formatLevel` writes it: -0 is 0. */
const canonical = (file: LevelFile): LevelFile => {
  const reading = readLevel(formatLevel(withIds(file)));
  if (!reading.ok) throw new Error(JSON.stringify(reading.problems));
  return reading.document.file;
};

const map = (objects: readonly object[], more: object = {}): string =>
  JSON.stringify({
    type: 'map',
    orientation: 'orthogonal',
    layers: [{ type: 'objectgroup', name: 'level', objects }],
    ...more,
  });
const astronaut = { id: 1, type: 'astronaut', x: 0, y: 0, point: true };
const blackHole = { id: 2, type: 'blackHole', x: 82, y: -18, width: 36, height: 36, ellipse: true };

describe('a level', () => {
  test('is the same after export to a map and import', () => {
    fc.assert(
      fc.property(arbitraryFile.map(canonical), (file) => {
        const { file: again, notes } = imported(formatTiled(exportTiled(file)));
        expect(notes).toEqual([]);
        expect(complete(again)).toEqual(complete(file));
      }),
      { numRuns: 60 },
    );
  });

  test('is the same by way of XML, but for characters that XML cannot hold', () => {
    const isPossible = (file: LevelFile) =>
      !/[\p{Cc}\p{Cs}\p{Cn}]/u.test(
        Object.values(file)
          .join()
          .replace(/[\t\n\r]/g, ''),
      );
    fc.assert(
      fc.property(arbitraryFile.map(canonical).filter(isPossible), (file) => {
        const bytes = new TextEncoder().encode(formatTmx(exportTiled(file)));
        expect(isTiledMap(bytes)).toBe(true);
        expect(complete(imported(bytes).file).at(0)).toEqual(complete(file).at(0));
      }),
      { numRuns: 40 },
    );
  });

  test('keeps what a merge left undecided', () => {
    const conflicts = [{ what: 'the range', key: 'range', base: [1], theirs: null }];
    const file = canonical({ version: 1, name: 'a', astronaut: { x: 0, y: 0 }, blackHole: { x: 9, y: 9 }, conflicts });
    expect(imported(formatTiled(exportTiled(file))).file.conflicts).toEqual(conflicts);
  });

  test('becomes a map whose circles are where the level has them, moved into the map as a whole', () => {
    const drawn = exportTiled({
      version: 1,
      name: 'Moved',
      astronaut: { x: -100, y: 7, vx: 3 },
      blackHole: { x: 300, y: 100 },
      minerals: [{ x: 5, y: 6 }],
      wormholes: [{ id: 'aa', x: 0, y: 0, toX: 50, toY: 60, radius: 10 }],
    });
    expect(drawn.properties).toEqual([
      { name: 'name', type: 'string', value: 'Moved' },
      { name: 'offsetX', type: 'float', value: 192 },
      { name: 'offsetY', type: 'float', value: 96 },
    ]);
    const objects = drawn.layers.flatMap((layer) => layer.objects);
    expect(objects[0]).toMatchObject({ type: 'astronaut', point: true, x: 92, y: 103, width: 0, height: 0 });
    expect(objects[1]).toMatchObject({ type: 'blackHole', ellipse: true, x: 474, y: 178, width: 36, height: 36 });
    expect(objects[2]).toMatchObject({ type: 'mineral', point: true, x: 197, y: 102 });
    expect(objects[3]).toMatchObject({ id: 4, type: 'wormhole', ellipse: true, x: 182, y: 86, width: 20 });
    expect(objects[3].properties).toContainEqual({ name: 'to', type: 'object', value: 5 });
    expect(objects[4]).toMatchObject({ id: 5, type: 'wormhole', ellipse: true, x: 232, y: 146 });
  });
});

/** What Tiled's description of its JSON map format asks of maps, layers of objects and objects. */
function expectValid(drawn: TiledMap): void {
  const whole = (value: unknown, least: number) => expect(Number.isInteger(value) && (value as number) >= least).toBe(true);
  expect(drawn).toMatchObject({
    type: 'map',
    orientation: 'orthogonal',
    infinite: false,
    renderorder: 'right-down',
    tilesets: [],
  });
  for (const value of [drawn.width, drawn.height, drawn.tilewidth, drawn.tileheight]) whole(value, 1);
  const ids = drawn.layers.flatMap(({ objects }) => objects.map(({ id }) => id));
  expect(new Set(ids).size).toBe(ids.length);
  expect(new Set(drawn.layers.map(({ id }) => id)).size).toBe(drawn.layers.length);
  for (const id of ids) expect(id).toBeLessThan(drawn.nextobjectid);
  for (const layer of drawn.layers) {
    expect(layer).toMatchObject({ type: 'objectgroup', draworder: 'index', opacity: 1, visible: true, x: 0, y: 0 });
    expect(layer.id).toBeLessThan(drawn.nextlayerid);
    expect(layer.color).toMatch(/^#[0-9a-f]{6}$/);
    for (const object of layer.objects) {
      whole(object.id, 1);
      for (const key of ['x', 'y', 'width', 'height'] as const) expect(Number.isFinite(object[key])).toBe(true);
      expect(object.width).toBeGreaterThanOrEqual(0);
      expect([object.ellipse, object.point].filter((one) => one === true)).toHaveLength(1);
      expect(object.rotation).toBe(0);
    }
  }
  const properties = [drawn.properties, ...drawn.layers.flatMap(({ objects }) => objects.map((one) => one.properties ?? []))];
  for (const list of properties) {
    expect(new Set(list.map(({ name }) => name)).size).toBe(list.length);
    for (const { type, value } of list) {
      const is = { string: 'string', bool: 'boolean', int: 'number', float: 'number', object: 'number' }[type];
      expect(typeof value).toBe(is);
      if (type === 'object') expect(ids).toContain(value);
    }
  }
}

test('every map is as the JSON map format of Tiled says', () => {
  fc.assert(
    fc.property(arbitraryFile.map(canonical), (file) => {
      const drawn = exportTiled(file);
      expectValid(drawn);
      expect(JSON.parse(formatTiled(drawn))).toEqual(drawn);
    }),
    { numRuns: 30 },
  );
});

describe('a map that a person drew', () => {
  test('is read with its groups, offsets, layers named after a kind, and shapes of several tools', () => {
    const { file, slug, notes } = imported(fixture('drawn.tmj'));
    expect(slug).toBe('a-map');
    expect(resolveLevel(file)).toMatchObject({
      name: 'Drawn by hand',
      recoil: true,
      range: 250,
      astronaut: { x: 0, y: 0 },
      blackHole: { x: 170, y: 0, radius: 18 },
      asteroids: [
        { x: 100, y: 0, radius: 16, hot: false },
        { x: 332.5, y: 132, radius: 32, hot: true },
      ],
      minerals: [{ x: 140, y: 0, radius: 7 }],
      wormholes: [{ x: 520, y: 520, toX: 620, toY: 520, radius: 20 }],
    });
    expect(file.blackHole).toEqual({ x: 170, y: 0 });
    expect(notes).toEqual([
      'ignored the layer "Background": it is a layer of tiles',
      'ignored the tilesets of the map',
      'ignored the property "mood" of object 2',
      'ignored object 4: it is a text',
    ]);
  });

  test('with mistakes is refused with all of them: object, class, line and column', () => {
    const said = problems(fixture('mistakes.tmx')).map(
      ({ line, column, code, message }) => `${line}:${column} ${code} | ${message}`,
    );
    expect(said).toEqual([
      '4:3 reversed-hold | run "first", hold 1: [96, 12] is reversed: the release must come after the press',
      '10:3 wrong-shape | object 2: expected a circle, found an ellipse of 36 x 30 px',
      '13:3 unknown-class | object 3 "rock": expected a class that is a kind of object, found "astroid": did you mean "asteroid"?',
      '16:3 wrong-shape | object 4: expected the rotation 0, found 45',
      '19:3 wrong-shape | object 5: expected a circle for the repulsor, found a rectangle',
      '20:3 unpaired-mouth | object 6: expected the other mouth of the wormhole, found none',
      '23:3 unknown-class | object 7: expected a class that is a kind of object, found "goody": did you mean "mineral"?',
      '26:3 one-per-level | object 8: a level has exactly one astronaut, and object 1 is one already',
      '29:3 unknown-class | object 9: expected a class that is a kind of object, found none',
      '32:3 wrong-shape | object 10: expected an object of its own, found an instance of a template, which is in another file',
      '33:3 wrong-shape | object 11: expected a circle for the asteroid, found a point',
      '38:49 out-of-limits | object 12: alien 1, radius: expected a number of at least 0.001, found -3',
    ]);
  });

  test.each([
    ['no astronaut', map([blackHole]), '1:1 missing-key  | expected an object of class "astronaut", found none'],
    [
      'an isometric map',
      map([astronaut, blackHole], { orientation: 'isometric' }),
      '1:29 unsupported-map /orientation | expected an orthogonal map, found the text "isometric" as orientation',
    ],
    ['a list', '[]', '1:1 wrong-type  | expected a Tiled map, found an empty list'],
    ['no layers', '{"type":"map"}', '1:1 wrong-type  | expected a list "layers", found nothing'],
    [
      'a place that is a text',
      map([{ ...astronaut, x: '3' }, blackHole]),
      'wrong-type /layers/0/objects/0/x | object 1: expected a number as x, found the text "3"',
    ],
    [
      'a tile',
      map([astronaut, blackHole, { id: 3, type: 'nova', gid: 7, x: 0, y: 0, width: 32, height: 32 }]),
      'wrong-shape /layers/0/objects/2 | object 3: expected a circle for the nova, found a tile',
    ],
    [
      'a mouth that leads to itself',
      map([
        astronaut,
        blackHole,
        { ...blackHole, id: 3, type: 'wormhole', properties: [{ name: 'to', type: 'object', value: 3 }] },
      ]),
      'unpaired-mouth /layers/0/objects/2 | object 3: expected the other mouth of the wormhole as "to", found itself',
    ],
    [
      'mouths of two sizes',
      map([
        astronaut,
        blackHole,
        { ...blackHole, id: 3, type: 'wormhole', properties: [{ name: 'to', type: 'object', value: 4 }] },
        { ...blackHole, id: 4, type: 'wormhole', width: 30, height: 30 },
      ]),
      'wrong-shape /layers/0/objects/3 | object 4: expected the radius 18 of object 3, the other mouth, found 15',
    ],
    [
      'runs that are not JSON',
      map([astronaut, blackHole], { properties: [{ name: 'runs', type: 'string', value: '[1' }] }),
      'wrong-type /properties/0/value | the property "runs" of the map: expected JSON as text, found a text that is not JSON',
    ],
    [
      'a bad id',
      map([astronaut, blackHole, { ...blackHole, id: 3, type: 'nova', properties: [{ name: 'id', value: 'A B' }] }]),
      'bad-id /layers/0/objects/2/properties/0/value | object 3: nova 1, id: expected 2 to 16 of the characters a-z and 0-9',
    ],
  ])('%s', (_, source, expected) => {
    const said = problems(source).map((p) => `${p.line}:${p.column} ${p.code} ${p.pointer} | ${p.message}`);
    expect(said).toHaveLength(1);
    expect(said[0]).toContain(expected);
  });

  test.each([
    ['<map ', '1:6 expected an attribute or >, found the end of the file'],
    ['<map>\n <objectgroup>\n</map>', '3:1 expected </objectgroup>, found </map>'],
    ['<map a="1" a="2"/>', '1:12 the attribute a is there more than once'],
    ['<map a="&nbsp;"/>', '1:9 expected one of'],
    ['<map><!-- ', '1:6 expected -->, which ends a comment'],
    [`${'<map>'.repeat(70)}`, '1:321 expected at most 64 elements'],
  ])('XML that is not well-formed: %s', (source, expected) => {
    const [{ line, column, message }] = problems(source);
    expect(`${line}:${column} ${message.replace('the text is not valid XML: ', '')}`).toContain(expected);
  });

  test('a copy made in Tiled gets an id of its own, and a note says so', () => {
    const nova = { ...blackHole, id: 3, type: 'nova', properties: [{ name: 'id', type: 'string', value: 'aaaa' }] };
    const { file, notes } = imported(map([astronaut, blackHole, nova, { ...nova, id: 4, x: 500 }]));
    expect(file.novae?.[0].id).toBe('aaaa');
    expect(file.novae?.[1].id).not.toBe('aaaa');
    expect(notes).toEqual(['object 4 has the id of another object: it gets one of its own']);
  });

  test('an object that was moved in Tiled is where it was moved to', () => {
    const file = { version: 1 as const, name: 'a', astronaut: { x: 0.1, y: 0 }, blackHole: { x: 0.3, y: 9 } };
    const drawn = JSON.parse(formatTiled(exportTiled(file)));
    expect(drawn.layers[1].objects[0].properties).toContainEqual({ name: 'exactX', type: 'float', value: 0.3 });
    expect(imported(JSON.stringify(drawn)).file.blackHole.x).toBe(0.3);
    drawn.layers[1].objects[0].x += 5;
    expect(imported(JSON.stringify(drawn)).file.blackHole.x).toBeCloseTo(5.3, 9);
  });
});

test('only maps are taken for maps', () => {
  expect(isTiledMap(fixture('drawn.tmj'))).toBe(true);
  expect(isTiledMap(fixture('mistakes.tmx'))).toBe(true);
  for (const other of ['', '{', '[]', '{"player":{}}', '{"version":1}', '<svg/>', '<?xml version="1.0"?><tileset/>']) {
    expect(isTiledMap(other)).toBe(false);
  }
});

test('both mouths of a wormhole may name each other, and a third may not', () => {
  const mouth = (id: number, to: number) => ({
    ...blackHole,
    id,
    x: 100 * id,
    type: 'wormhole',
    properties: [{ name: 'to', value: to }],
  });
  const { file } = imported(map([astronaut, blackHole, mouth(3, 4), mouth(4, 3)]));
  expect(file.wormholes).toMatchObject([{ x: 318, toX: 418 }]);
  const [{ pointer, message }] = problems(map([astronaut, blackHole, mouth(3, 4), mouth(4, 3), mouth(5, 4)]));
  expect([pointer, message]).toEqual([
    '/layers/0/objects/4',
    'object 5: expected a mouth without another partner as "to", found object 4',
  ]);
});

describe('what is hidden in Tiled is read, and said', () => {
  const nova = { id: 4, name: 'far', type: 'nova', x: 300, y: 276, width: 48, height: 48, ellipse: true };
  const hidden = { visible: false };

  test.each([
    ['an object', [{ type: 'objectgroup', name: 'o', objects: [{ ...nova, ...hidden }] }], ['object 4 "far"']],
    ['a layer', [{ type: 'objectgroup', name: 'o', objects: [nova], ...hidden }], ['the layer "o"']],
    [
      'a group in a group',
      [
        {
          type: 'group',
          name: 'g',
          layers: [{ type: 'group', name: 'h', ...hidden, layers: [{ type: 'objectgroup', name: 'o', objects: [nova] }] }],
        },
      ],
      ['the group "h"'],
    ],
    [
      'all of them',
      [
        {
          type: 'group',
          name: 'g',
          ...hidden,
          layers: [{ type: 'objectgroup', name: 'o', ...hidden, objects: [{ ...nova, ...hidden }] }],
        },
      ],
      ['the group "g"', 'the layer "o"', 'object 4 "far"'],
    ],
    ['nothing', [{ type: 'objectgroup', name: 'o', objects: [{ ...nova, visible: true }], visible: true }], []],
  ])('%s', (_, layers, said) => {
    const first = { type: 'objectgroup', name: 'first', objects: [astronaut, blackHole] };
    const { file, notes } = imported(JSON.stringify({ type: 'map', layers: [first, ...layers] }));
    expect(file.novae).toMatchObject([{ x: 324, y: 300, radius: 24 }]);
    expect(notes).toEqual(said.map((what) => `${what} is hidden, and was read all the same`));
  });

  test('also in XML, where 0 says it', () => {
    const hide = (text: string, what: string) => text.replace(what, `${what} visible="0"`);
    const tmx = formatTmx(exportTiled({ version: 1, name: 'a', astronaut: { x: 0, y: 0 }, blackHole: { x: 300, y: 9 } }));
    const { notes } = imported(hide(hide(tmx, '<object '), '<objectgroup '));
    expect(notes).toEqual([
      'the layer "astronaut" is hidden, and was read all the same',
      'object 1 is hidden, and was read all the same',
    ]);
  });
});

test.each([
  [{ name: 'hot', type: 'string', value: 'true' }, 'bool'],
  [{ name: 'hot', type: 'int', value: 1 }, 'bool'],
  [{ name: 'hot', value: 'true' }, 'bool'],
  [{ name: 'id', type: 'int', value: 7 }, 'string'],
  [{ name: 'hot', type: 'bool', value: 'yes' }, null],
])('a property of another type than the level needs is mended in Tiled: %j', (property, type) => {
  const rock = { ...blackHole, id: 3, type: 'asteroid', x: 200, properties: [property] };
  const [{ code, pointer, hint }] = problems(map([astronaut, blackHole, rock]));
  expect([code, pointer]).toEqual(['wrong-type', '/layers/0/objects/2/properties/0/value']);
  if (type === null) expect(hint).not.toContain('type of the property');
  else expect(hint).toContain(`Set the type of the property "${property.name}" to ${type} in Tiled`);
});

test.each([
  [
    'a radius',
    [{ ...astronaut, id: 3, type: 'alien', x: 90, properties: [{ name: 'radius', type: 'string', value: '30' }] }],
    {},
  ],
  ['the speed', [{ ...astronaut, properties: [{ name: 'vx', value: '3' }] }], {}],
  ['the range', [], { properties: [{ name: 'range', type: 'string', value: '250' }] }],
  ['the offset', [], { properties: [{ name: 'offsetX', type: 'string', value: '32' }] }],
])('%s as a text is mended in Tiled, too', (_, objects, more) => {
  const others = objects.some(({ type }) => type === 'astronaut') ? [blackHole] : [astronaut, blackHole];
  const said = problems(map([...others, ...objects], more)).filter(({ code }) => code === 'wrong-type');
  expect(said.map(({ hint }) => hint)).toEqual([expect.stringMatching(/^Set the type of the property "\w+" to float in Tiled/)]);
});

test('an instance of a template is to be detached, with or without a class, in JSON and in XML', () => {
  const instances = [
    { id: 3, template: 'rock.tj', x: 1, y: 1 },
    { id: 4, type: 'asteroid', template: 'rock.tj', x: 1, y: 1 },
  ];
  const xml = '<map><objectgroup><object id="3" template="rock.tx" x="1" y="1"/></objectgroup></map>';
  const said = [...problems(map([astronaut, blackHole, ...instances])), ...problems(xml)];
  const detach = said.filter(({ hint }) => hint.startsWith('Choose Detach'));
  expect(detach.map(({ message }) => message.slice(0, 9))).toEqual(['object 3:', 'object 4:', 'object 3:']);
  expect(said.filter(({ code }) => code === 'unknown-class')).toEqual([]);
});

test('a map in XML is one whatever stands before its element', () => {
  const parts = [
    '<?xml-stylesheet href="a.css"?>',
    '<!-- <map> -->',
    '<!DOCTYPE map>',
    '\n ',
    `<!--${'x'.repeat(9000)}-->`,
    '<?a?>',
  ];
  const tmx = formatTmx(exportTiled({ version: 1, name: 'a', astronaut: { x: 0, y: 0 }, blackHole: { x: 300, y: 9 } }));
  const [declaration] = tmx.split('\n');
  fc.assert(
    fc.property(fc.array(fc.constantFrom(...parts)), fc.boolean(), (before, isMarked) => {
      const text = `${isMarked ? '\ufeff' : ''}${tmx.replace(declaration, `${declaration}${before.join('')}`)}`;
      expect(isTiledMap(text)).toBe(true);
      expect(isTiledMap(new TextEncoder().encode(text))).toBe(true);
      expect(imported(text).notes).toEqual([]);
    }),
  );
});

describe('other files of level editors', () => {
  const header = { fileType: 'LDtk Project JSON', app: 'LDtk' };
  const world = (count: number) => Array.from({ length: count }, (_, i) => ({ fileName: `${i}.tmx`, x: 0, y: 0 }));

  test.each([
    ['a project of LDtk', { __header__: header, levels: [] }, '"LDtk Project JSON", a file of LDtk', 'Turn on Tiled export'],
    ['a level of LDtk', { __header__: { ...header, fileType: 'LDtk Level JSON' } }, '"LDtk Level JSON", a file', 'Turn on'],
    ['a world', { type: 'world', maps: world(2) }, 'a world of Tiled, which has the maps "0.tmx", "1.tmx"', 'Import each'],
    ['a large world', { type: 'world', maps: world(7) }, '"4.tmx" and 2 more', 'Import each'],
    ['a world of patterns', { type: 'world', patterns: [{}] }, 'names its maps by a pattern', 'Import each'],
    ['a world of old', { maps: world(1), onlyShowAdjacentMaps: false }, 'the maps "0.tmx"', 'Import each'],
    ['a tileset', { type: 'tileset', tiles: [] }, 'a tileset of Tiled', 'import the map'],
    ['a template', { type: 'template', object: {} }, 'a template of Tiled', 'Choose Detach'],
    ['a project of Tiled', { automappingRulesFile: '', folders: ['.'] }, 'a project of Tiled', 'import the maps'],
  ])('%s is named, with what to do', (_, value, found, hint) => {
    const reading = importOriginal(JSON.stringify(value), { recoil: true });
    expect(reading).toMatchObject({
      ok: false,
      problems: [{ code: 'not-a-level', message: expect.stringContaining(found), hint: expect.stringContaining(hint) }],
    });
    expect(isTiledMap(JSON.stringify(value))).toBe(false);
  });

  test.each([
    ['<?xml version="1.0"?><tileset name="a"/>', 'a tileset of Tiled'],
    ['<!-- a --><template><object/></template>', 'a template of Tiled'],
  ])('also in XML: %s', (source, found) => {
    const reading = importOriginal(source, { recoil: true });
    expect(reading).toMatchObject({ ok: false, problems: [{ message: expect.stringContaining(found) }] });
  });
});

test('git markers in a map are named, wherever they are', () => {
  const tmx = formatTmx(exportTiled({ version: 1, name: 'a', astronaut: { x: 0, y: 0 }, blackHole: { x: 300, y: 9 } }));
  const lines = tmx.trimEnd().split('\n');
  for (let at = 1; at < lines.length; at++) {
    const merged = [...lines.slice(0, at), '<<<<<<< HEAD', lines[at], '=======', lines[at], '>>>>>>> b', ...lines.slice(at + 1)];
    expect(isTiledMap(merged.join('\n')), String(at)).toBe(true);
    const [{ code, line }] = problems(merged.join('\n'));
    expect([code, line]).toEqual(['merge-markers', at + 1]);
  }
});

test('a beginning that goes on and on is recognized at once', () => {
  for (const source of ['/'.repeat(4000), '//\n'.repeat(1300), '<!---->'.repeat(580), '<!-- '.repeat(800)]) {
    expect(isTiledMap(`${source}{`)).toBe(false);
    expect(importOriginal(`${source}{`, { recoil: true }).ok).toBe(false);
  }
});

test('no content makes it throw', () => {
  const sources = [new TextDecoder().decode(fixture('drawn.tmj')), new TextDecoder().decode(fixture('mistakes.tmx'))];
  const cut = fc.tuple(fc.constantFrom(...sources), fc.nat(), fc.nat(60), fc.string({ maxLength: 4 }));
  fc.assert(
    fc.property(cut, ([source, at, length, put]) => {
      const start = at % source.length;
      const changed = source.slice(0, start) + put + source.slice(start + length);
      const reading = importTiled(changed, { slug: 'x' });
      if (reading.ok) expect(readLevel(formatLevel(reading.levels[0].file)).ok).toBe(true);
      else expect(reading.problems.length).toBeGreaterThan(0);
    }),
    { numRuns: 200 },
  );
});
