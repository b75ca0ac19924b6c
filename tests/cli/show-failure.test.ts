import { spawnSync } from 'node:child_process';
import process from 'node:process';
import { fileURLToPath } from 'node:url';
import { describe, expect, it } from 'vitest';
import type { CheckedLevel } from '../../cli/check/index.ts';
import { editorLinkTo, failureOf } from '../../cli/show-failure/index.ts';
import { placeIn } from '../../schema/index.ts';
import { gq, MAIN } from './gq.ts';

const level = (changes: Partial<CheckedLevel>): CheckedLevel => ({
  file: 'levels/07.level.json',
  name: 'Slingshot',
  terms: { accuracy: 'precise', maxTime: 60, maxWork: 400_000, rules: {} },
  verdict: 'broken',
  run: { name: 'solution', outcome: 'collided', time: 6.88, tick: 412, minerals: [], clearance: null },
  found: null,
  report: null,
  mineralCount: 0,
  problems: [],
  unreadable: false,
  ms: 1,
  ...changes,
});
const problem = (severity: 'error' | 'warning'): CheckedLevel['problems'][number] => ({
  code: 'slack-below-required',
  severity,
  message: '',
  hint: '',
  pointer: '',
  line: null,
  column: null,
  frame: '',
});
const completed = { ...level({}).run, outcome: 'completed' } as CheckedLevel['run'];

describe('where to look at the failure of a level', () => {
  it('is the tick at which its run fails', async () => {
    const linkTo = await editorLinkTo('https://example.org/editor/?a=b');
    expect(failureOf(level({}), linkTo)).toEqual({
      command: 'gq edit --open levels/07.level.json:412',
      link: 'https://example.org/editor/?a=b#level=levels/07.level.json&tick=412&run=solution',
      tick: 412,
    });
    expect(failureOf(level({}), null)).toEqual({ command: 'gq edit --open levels/07.level.json:412', link: null, tick: 412 });
  });

  it.each([
    ['no run', level({ verdict: 'unproven', run: null })],
    ['an invalid file', level({ verdict: 'invalid', run: null })],
    [
      'a run that completes the level, but forgives too little',
      level({ verdict: 'completable', run: completed, problems: [problem('error')] }),
    ],
  ])('is the level, if it has %s', async (_, failing) => {
    const linkTo = await editorLinkTo('http://127.0.0.1/');
    expect(failureOf(failing, linkTo)).toEqual({
      command: 'gq edit --open levels/07.level.json',
      link: 'http://127.0.0.1/#level=levels/07.level.json',
      tick: null,
    });
  });

  it.each([
    ['the level does not fail', level({ verdict: 'completable', run: completed, problems: [problem('warning')] })],
    ['the file can not be read', level({ verdict: 'crashed', run: null, unreadable: true })],
    ['the editor does not list files of this name', level({ file: 'level.json' })],
    ['there is no file', level({ file: '-' })],
  ])('is nowhere, if %s', (_, other) => {
    expect(failureOf(other, null)).toBeNull();
  });

  it('is quoted for a shell, and says nothing about the machine in a link', async () => {
    const linkTo = await editorLinkTo('https://example.org/');
    const levelIn = (file: string) => placeIn(new URL(failureOf(level({ file }), linkTo)?.link ?? '').hash)?.place.level;
    expect(failureOf(level({ file: 'my levels/$(x).level.json' }), null)?.command).toBe(
      "gq edit --open 'my levels/$(x).level.json:412'",
    );
    expect(levelIn('my levels/$(x)&tick=1#.level.json')).toBe('my levels/$(x)&tick=1#.level.json');
    expect(levelIn('../levels/./07.level.json')).toBe('levels/07.level.json');
    expect(levelIn('levels\\world\\07.level.json')).toBe('levels/world/07.level.json');
    expect(levelIn('/srv/game/levels/07.level.json')).toBe('07.level.json');
    expect(levelIn('C:\\me\\levels\\07.level.json')).toBe('07.level.json');
  });
});

describe('gq check --editor-url', () => {
  const cwd = fileURLToPath(new URL('./fixtures', import.meta.url));
  const ARGS = ['check', 'levels/04-no-run.level.json'];
  const check = (args: string[]) => gq([...ARGS, ...args], { cwd });
  const checkIn = (GQ_EDITOR_URL: string) =>
    spawnSync(process.execPath, [MAIN, ...ARGS], {
      cwd,
      env: { ...process.env, NO_COLOR: '1', GQ_EDITOR_URL },
      encoding: 'utf8',
    });

  it('links to the page in every report; the environment may name it as well', async () => {
    const link = 'https://example.org/e/#level=levels/04-no-run.level.json';
    const [pretty, json, github] = await Promise.all([
      check(['--editor-url', 'https://example.org/e/']),
      check(['--editor-url', 'https://example.org/e/', '--format', 'json']),
      check(['--editor-url', 'https://example.org/e/', '--format', 'github']),
    ]);
    expect(pretty.stdout).toContain(`    look at it: gq edit --open levels/04-no-run.level.json, or ${link}\n`);
    expect(JSON.parse(json.stdout).levels[0].failure.link).toBe(link);
    expect(github.stdout).toContain(link);
    expect(checkIn('https://example.org/e/#').stdout).toBe(pretty.stdout);
    expect(checkIn('').stdout).toContain('    look at it: gq edit --open levels/04-no-run.level.json\n');
  });

  it.each([
    ['example.org', /expected an address that begins with https/],
    ['javascript:alert(1)', /expected an address that begins with https/],
    ['https://me:secret@example.org/', /without a password or a token/],
    ['http://127.0.0.1:4747/#token=abc', /without a password or a token/],
  ])('refuses %s', async (url, message) => {
    const ended = await check(['--editor-url', url]);
    expect(ended).toMatchObject({ code: 2, stdout: '' });
    expect(ended.stderr).toMatch(message);
  });
});
