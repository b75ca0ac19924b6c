import { runInNewContext } from 'node:vm';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { packedLevel, packScript, pageOf } from '../../check/pack/index.ts';
import { levelHash } from '../../game/index.ts';
import { type LevelFile, type OwnRules, RULE_NAMES, RULES, readLevel, resolveLevel } from '../../schema/index.ts';
import { arbitraryFile } from '../editor/arbitrary-file.ts';

const run = (script: string): unknown => {
  const context: Record<string, unknown> = {};
  runInNewContext(script, context);
  return context.GRAVITY_QUEST_PACK;
};

const hard = fc.constantFrom('</script>', '<!--', '\u2028', '\u2029', '"', '\\', '__proto__', '\ud800', 'é', '\0', '$&', '`');

describe('the script of a pack', () => {
  it('says what was put into it, and nothing in it ends a script', () => {
    const text = fc.array(fc.oneof(hard, fc.string()), { maxLength: 6 }).map((parts) => parts.join(''));
    fc.assert(
      fc.property(
        text,
        fc.array(fc.record({ id: text, level: fc.record({ name: text }) }), { maxLength: 3 }),
        (title, levels) => {
          const pack = { title, accuracy: 'precise' as const, maxTime: 60, levels };
          const script = packScript(pack);
          expect(run(script)).toEqual(pack);
          expect(script).not.toMatch(/[<\u2028\u2029]/);
          expect(packScript(structuredClone(pack))).toBe(script);
        },
      ),
    );
  });
});

describe('a level in a pack', () => {
  const options = { rules: {}, withRuns: true, found: null };
  const file: LevelFile = {
    version: 1,
    $schema: '../schema.json',
    name: 'A',
    astronaut: { x: 0, y: 0 },
    blackHole: { x: 170, y: 0 },
    asteroids: [{ x: 100, y: 0, radius: 16, ...{ 'x-note': 'mine' } }],
    runs: [{ name: 'solution', holds: [[0, 600]], notes: [{ tick: 0, text: 'for its author' }] }],
    allow: { 'no-run': 'because' },
    conflicts: [],
    'x-author': { mail: 'a@b' },
  } as LevelFile;

  it('keeps what is played and shown, and leaves out what is for its authors', () => {
    expect(packedLevel(file, options)).toEqual({
      version: 1,
      name: 'A',
      astronaut: { x: 0, y: 0 },
      blackHole: { x: 170, y: 0 },
      asteroids: [{ x: 100, y: 0, radius: 16 }],
      runs: [{ name: 'solution', holds: [[0, 600]] }],
    });
  });

  it('gets a run that was found beside its own, or no runs at all', () => {
    const found = [[3, 9]] as const;
    expect(packedLevel(file, { ...options, found })).toMatchObject({
      runs: [
        { name: 'solution', holds: [[0, 600]] },
        { name: 'solution-2', holds: [[3, 9]] },
      ],
    });
    expect(packedLevel(file, { ...options, found, withRuns: false })).not.toHaveProperty('runs');
    expect(packedLevel({ ...file, runs: undefined }, options)).not.toHaveProperty('runs');
  });

  it('plays as in its folder: whatever the rules of both are, a play of one counts for the other', () => {
    const rules: fc.Arbitrary<OwnRules> = fc.record(
      Object.fromEntries(
        RULE_NAMES.map((name) => [name, fc.constantFrom(RULES[name].default, RULES[name].least, RULES[name].most, undefined)]),
      ),
    );
    fc.assert(
      fc.property(arbitraryFile, rules, fc.boolean(), (file, folder, withRuns) => {
        const packed = readLevel(JSON.stringify(packedLevel(file, { rules: folder, withRuns, found: null })));
        expect(packed.ok && levelHash(packed.level)).toBe(levelHash(resolveLevel(file, folder)));
        expect(packed.ok && packed.level.runs).toEqual(withRuns ? (file.runs ?? []).map(({ notes: _, ...run }) => run) : []);
      }),
    );
  });
});

describe('the page of a pack', () => {
  const game = `<!doctype html>
<html>
  <head>
    <meta charset="utf-8" />
    <title>Gravity Quest</title>
    <script defer src="./pack.js" ></script>
    <script defer src="./game.js"></script>
  </head>
</html>
`;

  it('has the title and a policy, and loads the pack once, before the game', () => {
    const page = pageOf(game, 'A <b> & $& "c"');
    expect(page).toContain('<title>A &lt;b&gt; &amp; $&amp; &quot;c&quot;</title>');
    expect(page.match(/<script[^>]*>/g)).toEqual(['<script src="./pack.js">', '<script defer src="./game.js">']);
    expect(page).toMatch(/http-equiv="Content-Security-Policy" content="default-src 'none'; script-src 'self'; /);
    expect(pageOf(page, 'other')).toBe(pageOf(game, 'other'));
  });

  it.each([
    ['a title', game.replace(/<title>.*<\/title>/, '')],
    ['its character set', game.replace(/<meta[^>]*>/, '')],
    ['a script', game.replaceAll(/<script.*<\/script>/g, '')],
  ])('is not made of a page without %s', (what, page) => {
    expect(() => pageOf(page, 'A')).toThrow(`it lacks ${what}`);
  });
});
