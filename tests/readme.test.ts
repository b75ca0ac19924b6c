import { mkdirSync, readFileSync, symlinkSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { afterAll, describe, expect, it } from 'vitest';
import { gq, makeFiles } from './cli/gq.ts';

// README shows commands and what they print: this reads it as its reader would, from top to bottom, and looks at what comes out

const project = fileURLToPath(new URL('..', import.meta.url));
const readme = readFileSync(join(project, 'README.md'), 'utf8');
const { directory, remove } = makeFiles({});
symlinkSync(join(project, 'levels'), join(directory, 'levels'), 'junction');
mkdirSync(join(directory, 'my'));
afterAll(remove);

const LEVEL = join(directory, 'my', 'moon.level.json');
const level = (): string => readFileSync(LEVEL, 'utf8');

const run = async (command: string, cwd: string): Promise<string> =>
  (await gq(command.replace('npx gq ', '').split(' '), { cwd })).stdout;

interface Step {
  readonly title: string;
  readonly take: () => Promise<void> | void;
}

/** What the reader does at a block of code, or where the prose asks to change the level. */
function stepsOf(text: string): Step[] {
  const steps: Step[] = [];
  const parts = text.matchAll(/^```(\w*)\n([\s\S]*?)^```$|Move it to `([^`]+)`/gm);
  for (const [, language, code, place] of parts) {
    if (place !== undefined) {
      const take = () => writeFileSync(LEVEL, level().replace(/("novae": \[\{ )"x": \d+, "y": \d+/, `$1${place}`));
      steps.push({ title: `moves the nova to ${place}`, take });
    } else if (language === 'json' && code.includes('"player"')) {
      steps.push({ title: 'has levels of the original', take: () => writeFileSync(join(directory, 'original.json'), code) });
    } else if (language === 'json' && code.startsWith('{')) {
      steps.push({ title: 'makes a level', take: () => writeFileSync(LEVEL, code) });
    } else if (language === 'json') {
      const take = () => writeFileSync(LEVEL, level().replace(/\n}\n$/, `,\n${code}}\n`));
      steps.push({ title: 'adds to the level', take });
    } else if (code.startsWith('$ npx gq ')) {
      const [command, ...printed] = code.slice(2).trimEnd().split('\n');
      const take = async () => expect((await run(command, directory)).trimEnd()).toBe(printed.join('\n'));
      steps.push({ title: command, take });
    } else if (code.startsWith('my/moon.level.json:')) {
      const take = async () => {
        const before = level();
        writeFileSync(LEVEL, before.replace('novae', 'novea').replace('"x": 300, "y": 260', '"x": 330, "y": 170'));
        expect(await run('npx gq check my', directory)).toContain(code);
        writeFileSync(LEVEL, before);
      };
      steps.push({ title: 'misspells a key', take });
    }
  }
  return steps;
}

describe('README', () => {
  const steps = stepsOf(readme);

  it('has commands with what they print', () => {
    expect(steps.filter(({ title }) => title.startsWith('npx gq')).length).toBeGreaterThan(5);
  });

  it.each(steps)('$title', ({ take }) => take());

  const pictures = [...readme.matchAll(/^npx gq render (\S+) -o (docs\/\S+\.svg) (.*)$/gm)];
  it.each(pictures.map(([command, file, picture, rest]) => ({ command, file, picture, rest })))(
    'the picture $picture is what its command makes: $command',
    async ({ file, picture, rest }) => {
      expect(readme).toContain(`](${picture})`);
      const made = await run(`npx gq render ${file} -o - ${rest}`, project);
      expect(made === readFileSync(join(project, picture), 'utf8'), 'run the command and commit the picture').toBe(true);
    },
  );
});
