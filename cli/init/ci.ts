import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join, relative, resolve, sep } from 'node:path';
import { readRegularFile, repositoryOf, tryGit } from '../io/index.ts';
import { Failure, shellWord, systemReason } from '../terminal/index.ts';

/** Where levels are checked for everybody. */
export type Ci = 'github' | 'gitlab' | 'none';

/** A file of a project that a plan is about. */
export interface PlannedText {
  readonly file: string;
  /** Its new text; null: it is left as it is. */
  readonly text: string | null;
  /** Why it is left, or what else to do. */
  readonly note?: string;
}

/** The address of the repository's origin; '' if there is none, or no git. */
function originOf(root: string): string {
  if (!existsSync(join(root, '.git'))) return '';
  const answer = tryGit(['remote', 'get-url', 'origin'], { folder: root, timeout: 5000 });
  return answer instanceof Error ? '' : answer.output.toString();
}

/** What the repository uses; where nothing says it, GitHub. */
export function chooseCi(folder: string): Ci {
  const root = repositoryOf(folder);
  if (existsSync(join(root, '.gitlab-ci.yml'))) return 'gitlab';
  if (existsSync(join(root, '.github'))) return 'github';
  return /gitlab/i.test(originOf(root)) ? 'gitlab' : 'github';
}

const CHECKS = /\bgq check\b|gravity-quest-toolkit/;

/** Texts that are no texts in some version of YAML. */
const WORDS = /^(?:true|false|null|yes|no|on|off|y|n)$/i;

/** A text as a value of YAML. */
const inYaml = (text: string): string =>
  /^(?:\.\/)?[a-z_](?:[\w./ -]*[\w./-])?$/i.test(text) && !WORDS.test(text) ? text : JSON.stringify(text);

/** The workflow for a project in a folder of the repository: paths lead there. */
function githubWorkflow(folder: string): string {
  const text = readTemplate('github-workflow.yml');
  if (folder === '') return text;
  return text
    .replaceAll('working-directory: .', () => `working-directory: ${inYaml(folder)}`)
    .replace(
      /: (\.\/node_modules\/.*|\.\/package-lock\.json)$/gm,
      (_, path: string) => `: ${inYaml(`./${folder}${path.slice(1)}`)}`,
    );
}

function gitlabJob(folder: string): string {
  const text = readTemplate('gitlab-ci.yml');
  if (folder === '') return text;
  return text
    .replace('    - npm ci', () => `    - ${inYaml(`cd ${shellWord(folder)}`)}\n    - npm ci`)
    .replace('        - package-lock.json', () => `        - ${inYaml(`${folder}/package-lock.json`)}`)
    .replace('junit: gq-junit.xml', () => `junit: ${inYaml(`${folder}/gq-junit.xml`)}`);
}

function planGithub(root: string, folder: string): PlannedText {
  const workflows = join(root, '.github', 'workflows');
  const file = join(workflows, 'levels.yml');
  const names = existsSync(workflows) ? readdirSync(workflows).filter((name) => /\.ya?ml$/.test(name)) : [];
  const checking = names.sort().find((name) => CHECKS.test(readText(join(workflows, name)) ?? ''));
  if (checking !== undefined) return { file: join(workflows, checking), text: null, note: 'it checks levels already' };
  if (names.includes('levels.yml')) return { file, text: null, note: 'it exists; templates/github-workflow.yml shows the steps' };
  return { file, text: githubWorkflow(folder) };
}

function planGitlab(root: string, folder: string): PlannedText {
  const main = join(root, '.gitlab-ci.yml');
  const before = readText(main);
  if (before === null) return { file: main, text: gitlabJob(folder) };
  const name = 'levels.gitlab-ci.yml';
  if (CHECKS.test(before) || before.includes(name)) return { file: main, text: null, note: 'it checks levels already' };
  const file = join(root, name);
  if (existsSync(file)) return { file, text: null, note: `it exists; .gitlab-ci.yml does not include it yet` };
  return { file, text: gitlabJob(folder), note: `include it in .gitlab-ci.yml: include: [{ local: ${name} }]` };
}

const OTHER_LOCKS: readonly (readonly [file: string, manager: string])[] = [
  ['pnpm-lock.yaml', 'pnpm'],
  ['yarn.lock', 'yarn'],
  ['bun.lock', 'bun'],
  ['bun.lockb', 'bun'],
];

/** Says that a new workflow installs with npm where the project uses another package manager. */
function withManager(planned: PlannedText, folders: readonly string[]): PlannedText {
  if (planned.text === null) return planned;
  const found = OTHER_LOCKS.find(([file]) => folders.some((folder) => existsSync(join(folder, file))));
  if (found === undefined) return planned;
  const note = `it installs with npm ci: change that to ${found[1]}, which this project uses`;
  return { ...planned, note: planned.note === undefined ? note : `${planned.note}; ${note}` };
}

/** The file by which everybody's levels are checked; null if none is wanted. */
export function planCi(folder: string, ci: Ci): PlannedText | null {
  const root = repositoryOf(folder);
  const inside = relative(root, resolve(folder)).split(sep).join('/');
  if (ci === 'none') return null;
  return withManager(ci === 'github' ? planGithub(root, inside) : planGitlab(root, inside), [folder, root]);
}

/** Files of a project that are read here are small: configuration, workflows, a manifest. Bytes. */
const LARGEST = 4 * 1024 * 1024;

/**
 * The text of a file of the project; null if there is none.
 * @throws Failure if it can't be read
 */
export function readText(path: string): string | null {
  try {
    return Buffer.from(readRegularFile(path, LARGEST)).toString();
  } catch (error) {
    if (['ENOENT', 'ENOTDIR'].includes((error as NodeJS.ErrnoException).code ?? '')) return null;
    throw new Failure(`${path}: can't be read: ${systemReason(error)}; gq init writes a file here`);
  }
}

const ROOT = new URL('../../../', import.meta.url);

/** A ready-made file of the package, in its folder `templates`. */
export const readTemplate = (name: string): string => readFileSync(new URL(`templates/${name}`, ROOT), 'utf8');

/** A level of the package. */
export const readShippedLevel = (name: string): string => readFileSync(new URL(`levels/${name}`, ROOT), 'utf8');
