import { dirname, resolve } from 'node:path';
import { type Command, Option } from 'commander';
import { plural } from '../../check/words/index.ts';
import type { Terms } from '../../engine/basics/index.ts';
import type { CommandHelp, CommandResult } from '../command.ts';
import { noConfiguration, readConfiguration } from '../config/index.ts';
import { readBytes, writeWhole } from '../io/index.ts';
import { type MergedFile, mergeFiles, mergeText, playAgain } from '../merge-driver/index.ts';
import { termsFrom, wholeNumberOption } from '../options/index.ts';
import { Failure, shellPath, systemReason, visibleLine } from '../terminal/index.ts';

interface Options {
  readonly markerSize: number;
  readonly onBrokenRun: 'stop' | 'warn';
}

/** Exit code: git ends the merge, instead of taking our version for the result of a conflict. */
const FAILED = 129;

/** This many conflicts are named in a message. */
const MOST_NAMED = 5;

export const help: CommandHelp = {
  description:
    'Merge two versions of a level for git: by object, run and field. gq git-setup tells git to use it for level files.',
  more: `
What only one side changed is taken. What both changed differently stays as we have it, and the file lists both values under
"conflicts": it is a valid level, which gq check refuses until gq edit or a person has decided. After a clean merge the runs are
played again, under the terms of the gq.config.json that is nearest to the level. Files that are no valid levels are merged as text.

Exit code: 0 merged; 1 a person must look: a conflict, or no run completes the merged level although one did on both sides; 129
the files could not be read or written.`,
};

export function declare(command: Command, finish: (result: CommandResult) => void): void {
  command
    .argument('<base>', 'the version that both started from, %O; an empty file if both added the level')
    .argument('<ours>', 'our version, %A, which becomes the result')
    .argument('<theirs>', 'their version, %B')
    .argument('<path>', 'the path of the level in the repository, %P: the gq.config.json of its folder applies')
    .option(
      '--marker-size <n>',
      'the length of conflict marks in files that are no levels, %L',
      wholeNumberOption('a length', 1, 1000),
      7,
    )
    .addOption(
      new Option('--on-broken-run <what>', 'when no run completes the merged level any more: stop for a look, or only warn')
        .choices(['stop', 'warn'])
        .default('stop'),
    )
    .action(async (base: string, ours: string, theirs: string, path: string, options: Options) =>
      finish(await drive({ base, ours, theirs, path }, options)),
    );
}

interface Paths {
  readonly base: string;
  readonly ours: string;
  readonly theirs: string;
  readonly path: string;
}

async function drive(paths: Paths, options: Options): Promise<CommandResult> {
  const say = (text: string) => `${visibleLine(`${paths.path}: ${text}`)}\n`;
  try {
    const notes: string[] = [];
    const terms = await termsOfFolder(dirname(resolve(paths.path)), notes);
    const merged = mergeOrSayWhy(paths, terms);
    const result = await finishMerge(merged, paths, options, terms);
    return { messages: [...notes, ...result.messages].map(say).join(''), exitCode: result.exitCode };
  } catch (error) {
    if (!(error instanceof Failure)) throw error;
    return { messages: say(error.message), exitCode: FAILED };
  }
}

/** Merges the files; an error of gq itself must not hide their version, so git's own merge follows it. */
function mergeOrSayWhy({ base, ours, theirs }: Paths, { rules }: Terms): MergedFile {
  const [o, a, b] = [base, ours, theirs].map(readBytes);
  try {
    return mergeFiles(o, a, b, rules);
  } catch (error) {
    return { kind: 'no level', why: `gq crashed, please report it: ${systemReason(error)}` };
  }
}

/** The terms of a folder. A configuration that is broken in the middle of a merge must not stop the merge of levels. */
async function termsOfFolder(folder: string, notes: string[]): Promise<Terms> {
  try {
    return termsFrom({}, await readConfiguration({}, folder));
  } catch (error) {
    if (!(error instanceof Failure)) throw error;
    const terms = termsFrom({}, noConfiguration());
    notes.push(
      `the configuration can't be read, so the runs are played by the original game's rules at ${terms.accuracy.name}, at most ${terms.maxTime} s`,
    );
    return terms;
  }
}

interface Finished {
  readonly messages: readonly string[];
  readonly exitCode: 0 | 1 | 129;
}

async function finishMerge(
  merged: MergedFile,
  paths: Paths,
  { markerSize, onBrokenRun }: Options,
  terms: Terms,
): Promise<Finished> {
  const { base, ours, theirs, path } = paths;
  switch (merged.kind) {
    case 'one side':
      await writeWhole(ours, merged.bytes);
      return { messages: [], exitCode: 0 };
    case 'conflicts': {
      await writeWhole(ours, merged.text);
      return { messages: conflictMessages(merged.conflicts, path), exitCode: merged.conflicts.length > 0 ? 1 : 0 };
    }
    case 'no level': {
      const outcome = mergeText(base, ours, theirs, markerSize);
      const how = {
        clean: 'merged as text, without conflicts: check it',
        conflicts: 'merged as text: its conflicts are marked',
        'not merged': 'not merged: our version stands, and theirs is in git (git checkout --theirs)',
      }[outcome];
      return { messages: [`${merged.why}; ${how}`], exitCode: outcome === 'clean' ? 0 : 1 };
    }
    case 'clean': {
      await writeWhole(ours, merged.text);
      const { broken, isUnproved } = playAgain(merged.ours, merged.theirs, merged.merged, terms);
      const messages = broken.map((what) => `merged, and ${what}`);
      if (!isUnproved) return { messages, exitCode: 0 };
      if (broken.length === 0) messages.push('merged, and no run completes it any more (before: one did on both sides)');
      if (onBrokenRun === 'warn') return { messages, exitCode: 0 };
      const file = shellPath(path);
      messages.push(`fix it (gq edit ${file}, gq solve ${file} --write) or leave it so, and then: git add ${file}`);
      return { messages, exitCode: 1 };
    }
  }
}

function conflictMessages(conflicts: readonly { readonly what: string }[], path: string): string[] {
  const named = conflicts.slice(0, MOST_NAMED).map(({ what }) => what);
  const more = conflicts.length - named.length;
  const list = `${named.join('; ')}${more > 0 ? `; and ${more} more` : ''}`;
  const found =
    conflicts.length === 0
      ? 'merged, but an earlier merge left conflicts in it'
      : `${plural(conflicts.length, 'conflict')}: ${list}; our values stand in the file, and "conflicts" has both`;
  return [found, `to decide: gq edit ${shellPath(path)}, then: git add ${shellPath(path)}`];
}
