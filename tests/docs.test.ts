import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { afterAll, beforeAll, describe, expect } from 'vitest';
import { parse as parseYaml } from 'yaml';
import { describeDeep, describeQuick, itQuick as it, itDeep } from './depth.ts';
import { brokenLinks, missingFiles } from './docs/links.ts';
import { ALL_PAGES, isUpdating, PROJECT, RUN_PAGES, readPage, shownIn } from './docs/page.ts';
import { type Commands, openTerminal, readCommands, type Terminal, wordsOf } from './docs/terminal.ts';

// Reads the pages as their reader does, from top to bottom: makes the files, runs the commands, compares what is printed.
// `npm run docs:outputs` rewrites what is printed in the pages instead.

const manifest = JSON.parse(readFileSync(join(PROJECT, 'package.json'), 'utf8'));

let commands: Commands;
beforeAll(async () => {
  commands = await readCommands();
});

/** The seconds that a search took are the only printed figure that differs from machine to machine. */
const withoutSeconds = (text: string): string => text.replace(/(, )\d+\.\d s(, seed )/g, '$1N s$2');

/** What a page says in the section about what is not there yet is left out: it names what does not exist. */
const withoutMissing = (prose: string): string => prose.replace(/^## Not there yet\n[\s\S]*?(?=^## |(?![\s\S]))/m, '');

/** Pages whose commands search for seconds. */
const DEAR = ['docs/difficulty.md', 'docs/softlocks.md'];

function describePage(path: string): void {
  const page = readPage(path);
  let terminal: Terminal;
  /** What commands print now where the page shows something else, by the line of the command. Only while updating. */
  const printed = new Map<number, string>();

  beforeAll(() => {
    terminal = openTerminal();
  });

  afterAll(() => {
    terminal.close();
    if (printed.size === 0) return;
    const lines = page.text.split('\n');
    for (const block of page.blocks.filter(({ language }) => language === 'console').reverse()) {
      const fresh = shownIn(block).flatMap(({ command, printed: shown, line }) => {
        const now = printed.get(line) ?? shown;
        return [`$ ${command}`, ...(now === '' ? [] : now.split('\n'))];
      });
      lines.splice(block.line - 1, block.code.split('\n').length, ...fresh);
    }
    if (lines.join('\n') !== page.text) writeFileSync(join(PROJECT, path), lines.join('\n'));
  });

  const steps = page.blocks.flatMap((block) => {
    const { language, title, code, line } = block;
    if (title !== undefined) {
      return [{ step: `line ${line}: the reader makes ${title}`, take: () => terminal.write(title, `${code}\n`) }];
    }
    if (language !== 'console') return [];
    return shownIn(block).map(({ command, printed: shown, line }) => ({
      step: `line ${line}: ${command}`,
      take: async () => {
        const now = await terminal.run(command);
        if (withoutSeconds(now) === withoutSeconds(shown)) return;
        if (isUpdating()) printed.set(line, now);
        else expect(withoutSeconds(now)).toBe(withoutSeconds(shown));
      },
    }));
  });
  if (steps.length > 0) (DEAR.includes(path) ? itDeep : it).each(steps)('$step', ({ take }) => take());

  it('has code that can be read', () => {
    for (const { language, code, line, title } of page.blocks) {
      const where = `${path}:${line}`;
      if (language === 'json') expect(() => JSON.parse(/^\s*[{[]/.test(code) ? code : `{${code}}`), where).not.toThrow();
      if (language === 'yaml') expect(() => parseYaml(code), where).not.toThrow();
      if (language === 'js' || language === 'ts')
        expect(title, `${where}: a program needs a file name, and a line that runs it`).toBeDefined();
      if (title !== undefined) expect(page.text, `${where}: the page names the file`).toContain(`\`${title}\``);
    }
  });

  it('runs its programs', () => {
    const lines = page.blocks.filter(({ language }) => language === 'console').flatMap(shownIn);
    for (const { language, title } of page.blocks) {
      if (language === 'js') expect(lines.map(({ command }) => command)).toContain(`node ${title}`);
    }
  });

  it('names commands and options that exist', () => {
    const lines = page.blocks
      .filter(({ language }) => language !== 'console')
      .flatMap(({ code, line }) => code.split('\n').map((text, i) => ({ text, line: line + i })));
    for (const { text, line } of lines) {
      const found = /(?:^|- run: |&& |<!-- )npx gq (.*?)(?: -->)?$/.exec(text.trim());
      if (found === null) continue;
      const [command] = found[1].split(/ [|>] /);
      expect(commands.problemOf(wordsOf(command)), `${path}:${line}`).toBeNull();
    }
    const spans = [...withoutMissing(page.prose).matchAll(/`([^`\n]+)`/g)].map(([, span]) => span);
    for (const span of spans) {
      const gq = /^(?:npx )?gq ([a-z][a-z-]*)(.*)$/.exec(span);
      const flags = span.match(/(?<![\w-])--[a-z][a-z-]*/g) ?? [];
      if (gq !== null) {
        expect([...commands.names], span).toContain(gq[1]);
        for (const flag of flags) expect([...commands.optionsOf(gq[1])], span).toContain(flag);
      } else if (/^--[a-z]/.test(span)) {
        for (const flag of flags) expect([...commands.allOptions], span).toContain(flag);
      }
    }
  });
}

describe.each(DEAR)('%s', describePage);
describeQuick.each(RUN_PAGES.filter((path) => !DEAR.includes(path)))('%s', describePage);

describeQuick.each(ALL_PAGES)('%s', (path) => {
  const page = readPage(path);

  it('has links and pictures that are there', () => {
    expect(brokenLinks(page)).toEqual([]);
  });

  it('names npm scripts and files that exist', () => {
    const scripts = [...page.text.matchAll(/npm run (?:--silent )?([a-z][\w:-]*)/g)].map(([, script]) => script);
    expect(scripts.filter((script) => manifest.scripts[script] === undefined && !script.endsWith(':'))).toEqual([]);
    if (path !== 'CHANGELOG.md') expect(missingFiles(page)).toEqual([]);
    const packed = [...page.text.matchAll(/gravity-quest-toolkit-(\d+\.\d+\.\d+)\.tgz/g)].map(([, version]) => version);
    expect(packed.filter((version) => version !== manifest.version)).toEqual([]);
  });
});

describeQuick('README.md', () => {
  const { text, prose } = readPage('README.md');

  it('has at most 1,300 words', () => {
    expect(text.trim().split(/\s+/).length).toBeLessThanOrEqual(1300);
  });

  it('says of no command that it is missing when it is there', () => {
    const section = /^## Not there yet\n([\s\S]*?)(?=^## |(?![\s\S]))/m.exec(prose)?.[1] ?? '';
    expect(section).toContain('\n- ');
    const named = [...section.matchAll(/`gq ([a-z-]+)/g)].map(([, name]) => name);
    expect(named.filter((name) => commands.names.has(name))).toEqual([]);
    const options = [...section.matchAll(/`(--[a-z-]+)`/g)].map(([, flag]) => flag);
    expect(options.filter((flag) => commands.allOptions.has(flag))).toEqual([]);
  });
});

describeQuick('docs/accuracy.md', () => {
  const measured = JSON.parse(readFileSync(join(PROJECT, 'docs/accuracy.json'), 'utf8'));
  const { text } = readPage('docs/accuracy.md');
  const rows = [...text.matchAll(/^\| (`\w+`|[\w -]+ 60 Hz) +\|(.*\d of \d+) *\|$/gm)];
  const settings = new Map(
    [...measured.methods, ...measured.peers.filter(({ rate }: { rate: number }) => rate === 60)].map((setting) => [
      setting.name,
      setting,
    ]),
  );

  it.each(rows.map(([, name, cells]) => ({ name, cells })))('has the figures of docs/accuracy.json: $name', ({ name, cells }) => {
    const { error, cost, otherOutcomes, runs } = settings.get(name.replaceAll('`', '').replace(' 60 Hz', ''));
    const shown = cells.split('|').map((cell) => cell.trim());
    const figures = [error.median, error.p90, error.worst, cost];
    for (const [i, figure] of figures.entries()) {
      const digits = shown[i].replace(/e.*/, '').replace(/\D/g, '').length;
      expect(Number(shown[i])).toBe(Number(figure.toPrecision(digits)));
    }
    expect(shown[4]).toBe(`${otherOutcomes} of ${runs}`);
  });

  it('names the runs and the machine', () => {
    expect(rows.length).toBeGreaterThan(5);
    expect(text).toContain(`the ${measured.runs} runs of the shipped levels`);
    expect(text).toContain(`(${measured.machine.cpu}, Node ${measured.machine.node.slice(1)})`);
  });
});

describeDeep('programs in the pages', () => {
  const programs = RUN_PAGES.map(readPage).flatMap(({ path, blocks }) =>
    blocks
      .filter(({ language, title }) => title !== undefined && (language === 'js' || language === 'ts'))
      .map(({ code, title }) => ({ name: `${path.replace(/\W/g, '-')}/${title}`, code })),
  );

  const usesPhaser = ({ code }: { readonly code: string }): boolean => /from 'phaser'/.test(code);
  const strict = { strict: true, noEmit: true, allowJs: true, checkJs: true };
  // the compiler's own declarations need no check, those of the library do
  const inNode = { module: 'nodenext', lib: ['es2023'], types: ['node'], skipDefaultLibCheck: true };
  // Phaser's own declarations have errors
  const inBrowser = { module: 'esnext', moduleResolution: 'bundler', lib: ['es2023', 'dom'], types: [], skipLibCheck: true };

  itDeep.each([
    { where: 'in Node', those: programs.filter((program) => !usesPhaser(program)), options: inNode },
    { where: 'with Phaser', those: programs.filter(usesPhaser), options: { target: 'es2022', ...inBrowser } },
  ])('fit the types of the library $where', ({ those, options }) => {
    const directory = mkdtempSync(join(tmpdir(), 'gq-docs-'));
    try {
      mkdirSync(join(directory, 'node_modules'));
      symlinkSync(PROJECT, join(directory, 'node_modules/gravity-quest-toolkit'), 'junction');
      for (const name of ['@types', 'phaser']) {
        symlinkSync(join(PROJECT, 'node_modules', name), join(directory, 'node_modules', name), 'junction');
      }
      writeFileSync(join(directory, 'package.json'), '{ "type": "module" }');
      const compilerOptions = { ...strict, ...options };
      writeFileSync(join(directory, 'tsconfig.json'), JSON.stringify({ compilerOptions, files: those.map(({ name }) => name) }));
      for (const { name, code } of those) {
        mkdirSync(dirname(join(directory, name)), { recursive: true });
        writeFileSync(join(directory, name), code);
      }
      const tsc = join(PROJECT, 'node_modules/typescript/bin/tsc');
      const ended = spawnSync(process.execPath, [tsc, '-p', directory], { encoding: 'utf8' });
      expect(ended.stdout + ended.stderr).toBe('');
      expect(those.length).toBeGreaterThan(1);
    } finally {
      rmSync(directory, { recursive: true, force: true });
    }
  });
});

describeQuick('pictures', () => {
  const texts = RUN_PAGES.map((path) => readPage(path).text).join('\n');
  const makers = [...texts.matchAll(/npx gq render (\S+) -o (docs\/\S+\.svg)((?: --[a-z-]+| \w+)*)/g)];
  const drawn = new Map(
    makers.map(([, level, picture, rest]) => [picture, ['gq', 'render', level, '-o', '-', ...rest.trim().split(' ')]]),
  );
  const measured = ['docs/accuracy.svg', 'docs/fleet-model.svg', 'docs/packs.svg', 'docs/themes.svg', 'docs/tunnelling.svg'];

  it('are all made by a command that a page names', () => {
    // tests/hard-cases/page.test.ts draws those of docs/hard-cases.md
    const all = readdirSync(join(PROJECT, 'docs')).filter((name) => name.endsWith('.svg') && !name.startsWith('hard-cases-'));
    expect(all.map((name) => `docs/${name}`).sort()).toEqual([...new Set([...drawn.keys(), ...measured])].sort());
  });

  it.each([...drawn])('%s is what its command makes', async (picture, words) => {
    const terminal = openTerminal();
    const made = `${await terminal.run(`npx ${words.join(' ')}`)}\n`;
    terminal.close();
    const file = join(PROJECT, picture);
    if (isUpdating()) writeFileSync(file, made);
    else expect(made.trimEnd() === readFileSync(file, 'utf8').trimEnd(), `npm run docs:outputs makes ${picture} anew`).toBe(true);
    expect(existsSync(file)).toBe(true);
  });
});
