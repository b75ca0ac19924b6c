import { expect, it } from 'vitest';
import { CHECK_CODES } from '../../cli/check/codes.ts';
import { WARNING_CODES } from '../../engine/index.ts';
import { CODES } from '../../schema/index.ts';

const all = [...CHECK_CODES, ...CODES, ...WARNING_CODES];

it('every code is explained once, under a title that reads on after "code (error):"', () => {
  expect(new Set(all.map(({ code }) => code)).size).toBe(all.length);
  for (const { code, title, why, fix } of all) {
    expect(code).toMatch(/^[a-z0-9]+(-[a-z0-9]+)*$/);
    // begins small, but for a word that is always written so (NaN)
    expect(title, code).toMatch(/^(?:[a-z]|\w+[A-Z]).*[^.]$/s);
    expect(why, code).toMatch(/\.$/);
    expect(fix, code).toMatch(/[.:`)]$/);
  }
});
