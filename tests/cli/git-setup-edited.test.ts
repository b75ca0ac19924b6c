import { spawnSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { afterEach, beforeEach, expect, it } from 'vitest';
import { gq, makeFiles } from './gq.ts';

let folder: ReturnType<typeof makeFiles>;
const setUp = (...more: string[]) => gq(['git-setup', ...more], { cwd: folder.directory });
const attributes = () => join(folder.directory, '.gitattributes');
beforeEach(async () => {
  folder = makeFiles({ '.gitattributes': '*.png binary\n' });
  spawnSync('git', ['init', '-q'], { cwd: folder.directory });
  expect((await setUp()).code).toBe(0);
});
afterEach(() => folder.remove());

it('takes a line for levels to which somebody has added attributes, and leaves it when it is undone', async () => {
  const edited = readFileSync(attributes(), 'utf8').replace('eol=lf', 'eol=lf linguist-language=JSON');
  writeFileSync(attributes(), edited);
  expect(await setUp('--check')).toMatchObject({ code: 0 });
  expect((await setUp()).stdout).toBe('git merges and compares levels with gq\n');
  expect(readFileSync(attributes(), 'utf8')).toBe(edited);
  const undone = await setUp('--undo');
  expect(undone.stdout).toMatch(/left .*\.gitattributes:2: it was edited/);
  expect(readFileSync(attributes(), 'utf8')).toBe(
    '*.png binary\n*.level.json merge=gq-level diff=gq-level text eol=lf linguist-language=JSON\n',
  );
});

it('does not take a line that lacks one of its attributes', async () => {
  writeFileSync(attributes(), readFileSync(attributes(), 'utf8').replace(' diff=gq-level', ' linguist-language=JSON'));
  expect(await setUp('--check')).toMatchObject({ code: 1 });
});
