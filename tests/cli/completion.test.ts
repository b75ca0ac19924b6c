import { execFileSync, spawnSync } from 'node:child_process';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { COMMANDS } from '../../cli/commands/index.ts';
import { fallThrough, gq, makeFiles } from './gq.ts';

const runs = ['solution', 'a second one', "it's $(odd)"].map((name) => ({ name, holds: [[0, 600]] }));
const files = makeFiles({
  'levels/a.level.json': '{}',
  'levels/with space/b.level.json': '{}',
  'levels/notes.txt': '',
  'my.level.json': fallThrough({ runs }),
  'other.txt': '',
});
const cwd = files.directory;
afterAll(files.remove);

const SHELLS = ['bash', 'zsh', 'fish'] as const;
const scripts: Record<string, string> = {};
beforeAll(async () => {
  await gq(['fmt', 'my.level.json'], { cwd });
  for (const shell of SHELLS) {
    const { code, stdout, stderr } = await gq(['completion', shell]);
    expect([code, stderr]).toEqual([0, '']);
    scripts[shell] = stdout;
    writeFileSync(join(cwd, `.${shell}`), stdout);
  }
});

/** What bash offers for each line of words; the last word is the one to complete. */
function complete(lines: readonly (readonly string[])[]): string[][] {
  const quoted = (text: string): string => `'${text.replaceAll("'", "'\\''")}'`;
  const calls = lines.map(
    (words) =>
      `COMP_WORDS=(gq ${words.map(quoted).join(' ')}); COMP_CWORD=${words.length}; _gq; printf '%s\\n' "\${COMPREPLY[@]}"; echo --end--`,
  );
  // an unset variable is an error
  const output = execFileSync('bash', ['--norc', '-c', `set -u; source ./.bash; ${calls.join('\n')}`], { cwd, encoding: 'utf8' });
  return output
    .split('--end--\n')
    .slice(0, -1)
    .map((part) => part.split('\n').filter((line) => line !== ''));
}
const completeOne = (...words: string[]): string[] => complete([words])[0].sort();

/** Every long option that the help of a command names. */
const optionsInHelp = async (name: string): Promise<string[]> => {
  const { stdout } = await gq([name, '--help']);
  return [...stdout.matchAll(/^ {2}(?:-\w, )?(--[a-z-]+)/gm)].map(([, flag]) => flag).sort();
};

describe('completion in bash', () => {
  it('offers every command, and every option that its help names', async () => {
    const names = [...COMMANDS.map(({ name }) => name), 'help'];
    expect(completeOne('')).toEqual([...names, '-h', '--help', '-V', '--version'].sort());
    expect(completeOne('help', 'ch')).toEqual(['check']);
    expect(completeOne('ch')).toEqual(['check']);
    const offered = complete(COMMANDS.map(({ name }) => [name, '--']));
    for (const [i, { name }] of COMMANDS.entries())
      expect([name, ...offered[i].sort()]).toEqual([name, ...(await optionsInHelp(name))]);
  });

  it('offers the values of an option, in both ways to write it', () => {
    const accuracies = ['arcade', 'fast', 'precise', 'standard'];
    expect(completeOne('check', '--accuracy', '')).toEqual(accuracies);
    expect(completeOne('check', 'levels', '--accuracy', 's')).toEqual(['standard']);
    // readline cuts --accuracy=s in three
    expect(completeOne('check', '--accuracy', '=', 's')).toEqual(['standard']);
    expect(completeOne('check', '--accuracy', '=')).toEqual(accuracies);
    expect(completeOne('check', '--format', '')).toContain('github');
    expect(completeOne('check', '--reporter', 'j')).toContain('json');
    expect(completeOne('simulate', '--recoil', '')).toEqual(['off', 'on']);
    expect(completeOne('explain', 'no-r')).toEqual(['no-run', 'no-run-found']);
    expect(completeOne('explain', 'out-of-r')).toEqual(['out-of-range']);
    expect(completeOne('completion', '')).toEqual(['bash', 'fish', 'zsh']);
    // the value of --changed may be left out, so the next word is a path
    expect(completeOne('check', '--changed', 'le')).toEqual(['levels']);
  });

  it('offers folders and level files, and any file where any is taken', () => {
    expect(completeOne('check', '')).toEqual(['levels', 'my.level.json']);
    expect(completeOne('check', 'levels/')).toEqual(['levels/a.level.json', 'levels/with space']);
    expect(completeOne('check', 'levels/with\\ sp')).toEqual(['levels/with space']);
    expect(completeOne('check', '--lock', 'o')).toEqual(['other.txt']);
    expect(completeOne('generate', '--out', '')).toEqual(['levels']);
    expect(completeOne('check', 'nothing')).toEqual([]);
  });

  it('offers the names of the runs of the level before it', () => {
    expect(completeOne('simulate', 'my.level.json', '--run', '')).toEqual([
      'a\\ second\\ one',
      "it\\'s\\ \\$\\(odd\\)",
      'solution',
    ]);
    expect(completeOne('simulate', 'my.level.json', '--run', 'so')).toEqual(['solution']);
    expect(completeOne('simulate', '--run', '')).toEqual([]);
  });
});

describe('the scripts', () => {
  it('of zsh and fish offer the same options as that of bash', async () => {
    for (const { name } of COMMANDS) {
      const options = await optionsInHelp(name);
      const zsh = new RegExp(`\\n    ${name}\\)\\n(.*?)\\n      ;;`, 's').exec(scripts.zsh)?.[1] ?? '';
      expect([...zsh.matchAll(/'\*(--[a-z-]+)/g)].map(([, flag]) => flag).sort()).toEqual(options);
      const fish = scripts.fish.split('\n').filter((line) => line.includes(`from ${name}'`));
      expect(
        fish
          .flatMap((line) => / -l ([a-z-]+)/.exec(line)?.slice(1) ?? [])
          .map((flag) => `--${flag}`)
          .sort(),
      ).toEqual(options);
    }
  });

  it('have quotes and brackets in pairs, and pass the check of their shell where it is installed', () => {
    // zsh's script uses only what the grammars of both shells have
    for (const shell of ['bash', 'zsh'])
      expect(spawnSync('bash', ['-n', `.${shell}`], { cwd, encoding: 'utf8' })).toMatchObject({ status: 0, stderr: '' });
    for (const shell of SHELLS) {
      const { error, status, stderr } = spawnSync(shell, ['-n', `.${shell}`], { cwd, encoding: 'utf8' });
      if (error === undefined) expect([shell, status, stderr]).toEqual([shell, 0, '']);
    }
    // words of fish: quoted ones end on their line, and a quote within is escaped
    for (const line of scripts.fish.split('\n').filter((text) => text.startsWith('complete ')))
      expect(line).toMatch(/^complete(?: (?:[^\s'"$()]+|'(?:[^'\\]|\\.)*'))+$/);
  });

  it('are named when the shell is unknown', async () => {
    const { code, stderr } = await gq(['completion', 'powershell']);
    expect(code).toBe(2);
    expect(stderr).toContain('bash, zsh, fish');
  });
});
