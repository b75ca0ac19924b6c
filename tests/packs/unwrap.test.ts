import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import fc from 'fast-check';
import { afterAll, describe, expect, it } from 'vitest';
import { unwrap } from '../../cli/io/packs/batch.ts';
import { fallThrough, gq, makeFiles } from '../cli/gq.ts';

const place = makeFiles({});
afterAll(place.remove);

const textOf = (bytes: Uint8Array): string => Buffer.from(bytes).toString('latin1');

/** What JSON.parse makes of a line: the id and the level; null if it is no wrapped level. */
function parsed(line: Buffer): { readonly id: string | null; readonly level: unknown } | null {
  try {
    const { id = null, level, ...rest } = JSON.parse(line.toString());
    const isId = id === null || typeof id === 'string' || Number.isSafeInteger(id);
    return isId && level !== undefined && Object.keys(rest).length === 0 ? { id: id === null ? null : String(id), level } : null;
  } catch {
    return null;
  }
}

describe('a line of a pack', () => {
  it('is taken apart as JSON.parse does it, whatever its bytes are', () => {
    const alphabet = [
      '"',
      '\\',
      '{',
      '}',
      ',',
      ':',
      'id',
      'level',
      '"id":',
      '"level":',
      '\t',
      ' ',
      '1',
      '-',
      '\\u0041',
      '\\q',
      'é',
      '\u0000',
    ];
    const wrapped = ['{"id":"a","level":{"x":1}}', '{"level":{"x":1},"id":7}', '{"level":{"x":1}}', '{"x":1}'].map((text) =>
      Buffer.from(text),
    );
    fc.assert(
      fc.property(
        fc.constantFrom(...wrapped),
        fc.nat(),
        fc.nat(6),
        fc.array(fc.constantFrom(...alphabet), { maxLength: 4 }),
        (line, at, cut, pieces) => {
          const from = at % (line.length + 1);
          const mutated = Buffer.concat([line.subarray(0, from), Buffer.from(pieces.join('')), line.subarray(from + cut)]);
          const { id, content } = unwrap(mutated);
          const oracle = parsed(mutated);
          // a line that is left whole is read as a level, and refused
          if (textOf(content) === textOf(mutated)) return;
          if (oracle === null) expect(parsed(Buffer.concat([Buffer.from('{"level":'), content, Buffer.from('}')]))).toBe(null);
          else expect({ id, level: JSON.parse(Buffer.from(content).toString()) }).toEqual(oracle);
        },
      ),
      { numRuns: 5000 },
    );
  });

  it('does not end the check of the others if its id is not valid JSON', async () => {
    const level = fallThrough();
    const lines = [`{"id":"a\tb","level":${level}}`, `{"id":"a\\qb","level":${level}}`, `{"id":"good","level":${level}}`];
    writeFileSync(join(place.directory, 'odd.ndjson'), lines.map((line) => `${line}\n`).join(''));
    const { code, stdout } = await gq(['check', 'odd.ndjson', '--format', 'json'], { cwd: place.directory });
    expect(code).toBe(1);
    expect(JSON.parse(stdout).levels.map(({ file, verdict }: Record<string, string>) => [file, verdict])).toEqual([
      ['odd.ndjson#1', 'invalid'],
      ['odd.ndjson#2', 'invalid'],
      ['odd.ndjson#good', 'completable'],
    ]);
  });
});
