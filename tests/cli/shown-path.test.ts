import { execFileSync } from 'node:child_process';
import process from 'node:process';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { shellPath } from '../../cli/terminal/messages.ts';

describe('a path for a shell', () => {
  it.each([
    ['levels/07-slingshot.level.json:412', 'levels/07-slingshot.level.json:412'],
    ['a\\b.level.json', "'a\\b.level.json'"],
    ['my levels/a (2).level.json', '"my levels/a (2).level.json"'],
    ["it's.level.json", '"it\'s.level.json"'],
    ['-x.level.json', './-x.level.json'],
    ['-', '-'],
    ['$(rm -r x).level.json', "'$(rm -r x).level.json'"],
    ['', '""'],
  ])('%s', (path, quoted) => {
    expect(shellPath(path, 'linux')).toBe(quoted);
  });

  it('has double quotes on Windows', () => {
    expect(shellPath('C:\\levels\\07.level.json:412', 'win32')).toBe('C:\\levels\\07.level.json:412');
    expect(shellPath('C:\\my levels\\$07.level.json', 'win32')).toBe('"C:\\my levels\\$07.level.json"');
  });

  it.runIf(process.platform !== 'win32')('is one word with the same letters, and runs nothing', () => {
    const letters = fc.constantFrom(...'ab /\\\'"$`!*?()&;|<>#~=%{}[]^\n\t-:é');
    const names = fc.array(fc.string({ unit: letters, minLength: 1, maxLength: 12 }), { minLength: 20, maxLength: 20 });
    fc.assert(
      fc.property(names, (paths) => {
        const said = execFileSync('sh', ['-c', `printf '%s\\0' ${paths.map((path) => shellPath(path)).join(' ')}`], {
          encoding: 'utf8',
        });
        const expected = paths.map((path) => (path.startsWith('-') && path !== '-' ? `./${path}` : path));
        expect(said.split('\0').slice(0, -1)).toEqual(expected);
      }),
      { numRuns: 20 },
    );
  });
});
