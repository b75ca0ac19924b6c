import type { CommandModule } from '../command.ts';

interface CommandEntry {
  readonly name: string;
  readonly summary: string;
  /** Loads the command's module, and with it the engine or the renderer: only for the command that is used. */
  readonly load: () => Promise<CommandModule>;
}

/** Every command, in the order in which `gq --help` lists them. */
export const COMMANDS: readonly CommandEntry[] = [
  { name: 'check', summary: 'check that every level can be completed', load: () => import('./check/index.ts') },
  {
    name: 'simulate',
    summary: 'play one run of a level and report everything that happens',
    load: () => import('./simulate.ts'),
  },
  {
    name: 'solve',
    summary: 'find a run that completes a level, or prove that there is none',
    load: () => import('./solve.ts'),
  },
  {
    name: 'fix',
    summary: 'find the smallest change that makes a level completable',
    load: () => import('./fix/index.ts'),
  },
  {
    name: 'difficulty',
    summary: 'measure how hard levels are: success under timing noise, slack, shortcuts',
    load: () => import('./difficulty.ts'),
  },
  { name: 'tune', summary: "show what a change of the game's rules does to each level", load: () => import('./tune/index.ts') },
  {
    name: 'generate',
    summary: 'make new levels from a seed, a size and a difficulty',
    load: () => import('./generate/index.ts'),
  },
  {
    name: 'accuracy',
    summary: 'measure error and cost of every accuracy, for one run of a level',
    load: () => import('./accuracy/index.ts'),
  },
  {
    name: 'inspect',
    summary: 'show what a level calls for: effects, counts, warnings',
    load: () => import('./inspect.ts'),
  },
  {
    name: 'verify',
    summary: 'verify recorded plays: repeat their inputs and compare what comes of them with what they claim',
    load: () => import('./verify.ts'),
  },
  {
    name: 'submit',
    summary: 'run the shards of a plan on a cluster',
    load: () => import('./submit.ts'),
  },
  {
    name: 'plan',
    summary: 'split a large set of levels into shards for many machines',
    load: () => import('./plan/index.ts'),
  },
  { name: 'merge', summary: 'put the results of shards together, and miss nothing', load: () => import('./merge.ts') },
  { name: 'render', summary: 'draw a level and its run as SVG or PNG', load: () => import('./render/index.ts') },
  { name: 'diff', summary: 'show what changed in levels, and what that does to them', load: () => import('./diff/index.ts') },
  { name: 'merge-driver', summary: 'merge two versions of a level, for git', load: () => import('./merge-driver.ts') },
  { name: 'git-setup', summary: 'tell git to merge and compare levels with gq', load: () => import('./git-setup.ts') },
  {
    name: 'difftool',
    summary: 'show two versions of a level in the browser, for git difftool',
    load: async () => (await import('./diff/index.ts')).difftool,
  },
  {
    name: 'import',
    summary: "turn the original game's levels or a Tiled map into level files",
    load: () => import('./import.ts'),
  },
  {
    name: 'export',
    summary: "turn levels back into the original game's, or into Tiled maps",
    load: () => import('./export/index.ts'),
  },
  { name: 'build', summary: 'make a static page on which levels can be played', load: () => import('./build/index.ts') },
  {
    name: 'init',
    summary: 'put levels, configuration and a workflow for CI into a project',
    load: () => import('./init.ts'),
  },
  { name: 'fmt', summary: 'format level files', load: () => import('./fmt.ts') },
  { name: 'schema', summary: 'print the JSON Schema of a level file', load: () => import('./schema.ts') },
  {
    name: 'explain',
    summary: 'explain a problem: what it means, why it matters, how to fix it',
    load: () => import('./explain.ts'),
  },
  { name: 'edit', summary: 'edit levels in the browser, with a live run and verdict', load: () => import('./edit.ts') },
  {
    name: 'completion',
    summary: 'print the completion script of a shell: bash, zsh or fish',
    load: () => import('./completion/index.ts'),
  },
];
