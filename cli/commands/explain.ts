import process from 'node:process';
import type { Command } from 'commander';
import type { CodeExplanation, ExplainReport } from '../../schema/index.ts';
import type { ProofCode } from '../../solver/index.ts';
import type { CommandHelp, CommandResult } from '../command.ts';
import { EXPLAINED_CODES as ALL } from '../explained-codes.ts';
import { formatOption } from '../options/index.ts';
import { alignColumns } from '../report-parts/index.ts';
import { type Colors, colorsFor, didYouMean, Failure } from '../terminal/index.ts';

const WIDTH = 100;

/** The explanation of one code for people. */
function explainPretty({ code, severity, title, why, fix, example }: CodeExplanation, colors: Colors): string {
  const paint = severity === 'error' ? colors.red : colors.yellow;
  let text = `${colors.bold(code)} (${paint(severity)}): ${title}\n\n${wrap(why)}\n\n${colors.bold('How to fix it')}\n${wrap(fix)}\n`;
  if (example !== undefined) text += `\n${colors.bold('Example')}\n${example.replace(/^/gm, '  ')}\n`;
  return text;
}

/** One kind of proof in full, for a person. */
function explainProof({ code, title, why, fix, see }: ProofExplanation, colors: Colors): string {
  return `${colors.bold(code)} (kind of proof): ${title}\n\n${wrap(why)}\n\n${colors.bold('What to do')}\n${wrap(fix)}\n\nThe full argument: ${see}\n`;
}

/** Every code and every kind of proof on a line. */
function listCodes(codes: readonly CodeExplanation[], proofs: readonly ProofExplanation[], colors: Colors): string {
  const lines = alignColumns([
    ...codes.map(({ code, severity, title }) => [code, severity, title]),
    ...proofs.map(({ code, title }) => [code, 'proof', title]),
  ]);
  return `${lines.join('\n')}\n\n${colors.dim('gq explain CODE says more about one')}\n`;
}

function wrap(text: string): string {
  return text
    .split('\n')
    .map((paragraph) => {
      let line = '';
      const lines: string[] = [];
      for (const word of paragraph.split(' ')) {
        if (line !== '' && line.length + 1 + word.length > WIDTH) {
          lines.push(line);
          line = word;
        } else {
          line = line === '' ? word : `${line} ${word}`;
        }
      }
      return [...lines, line].join('\n');
    })
    .join('\n');
}

/** A kind of proof, as reports name it: "proved (out-of-range)". */
interface ProofExplanation {
  readonly code: string;
  readonly title: string;
  /** The idea of the proof. */
  readonly why: string;
  /** What to do about a level or a mineral of which this is proved. */
  readonly fix: string;
  /** Where the argument is written. */
  readonly see: string;
}

const EXPLANATIONS: Readonly<Record<ProofCode, Pick<ProofExplanation, 'title' | 'why' | 'fix'>>> = {
  'nothing-in-range': {
    title: 'no asteroid is in range of the start',
    why: 'She is lost when she is farther than the range from every asteroid. Here that is so at the start, so every run is over as it begins.',
    fix: 'Move the start and an asteroid nearer to each other, or raise the range.',
  },
  'starts-in-hazard': {
    title: 'the astronaut starts inside a hazard',
    why: 'At the start her collision box overlaps a nova, a hot asteroid or an alien, so every run is over as it begins.',
    fix: 'Move the start or the hazard that the message names.',
  },
  'out-of-range': {
    title: 'the object is out of range of every asteroid that she can reach',
    why:
      'She can pass from one asteroid to another only where their ranges overlap, or where an effect moves her from place to place at once. The proof lists every ' +
      'asteroid and mouth that she can reach in this way. The object is too far from all of them: she is lost before she touches it.',
    fix: 'Move the object nearer to an asteroid that she can reach, add an asteroid in the gap, or raise the range.',
  },
  covered: {
    title: 'hazards cover the object',
    why: 'Wherever her collision box touches the object, at any angle, it touches a hazard first, and the hazard ends the run.',
    fix: 'Move the object or one of the hazards until a part of the object is free.',
  },
  enclosed: {
    title: 'a closed barrier separates the object from the start',
    why:
      'Each piece of the barrier is blocked by a hazard that stands still, or is out of range. No gap in it is wide enough for her ' +
      'collision box.',
    fix: 'Open a gap that is wider than the message says, or move the object or the start to the other side.',
  },
  'line-trap': {
    title: 'she cannot leave a line that the object is not on',
    why:
      'She starts at rest, so the gun can only pull her along the line through the start and the nearest asteroid. Hazards or the ' +
      'edge of the range stop her at both ends of it, and the object is beside the line or beyond an end.',
    fix: 'Give her a velocity at the start, move the start, or make another asteroid become the nearest on the way.',
  },
  doomed: {
    title: 'every run ends before she can reach the object',
    why:
      'The proof follows all runs at once from her velocity at the start: boxes of places and velocities contain every run after ' +
      'each step. All of them end at hazards or out of range within seconds, and none comes near the object.',
    fix: 'Let her start slower, elsewhere or in another direction, or clear her path.',
  },
  flowpipe: {
    title: 'every run ends before she can reach the object (a tighter proof)',
    why:
      'As in doomed, all runs are followed at once, but more tightly and in continuous time only: the proof also follows the angle ' +
      'of her collision box, and aliens. All runs end at hazards or out of range, and none comes near the object.',
    fix: 'Let her start slower, elsewhere or in another direction, or clear her path.',
  },
  orbits: {
    title: 'every run ends before she can reach the object (a proof over a longer time)',
    why:
      'As in doomed, all runs are followed at once, but around the asteroid that is the nearest at each time: while the gun pulls ' +
      'her towards one asteroid, her angular momentum about it stays the same, so all runs stay close together for longer. All of ' +
      'them end at hazards or out of range, and none comes near the object. The proof covers the accuracy precise only.',
    fix: 'Let her start slower, elsewhere or in another direction, or clear her path.',
  },
};

/** The kinds of proof, in the order of docs/proofs.md. */
const PROOF_KINDS: readonly ProofExplanation[] = Object.entries(EXPLANATIONS).map(([code, explanation]) => ({
  code,
  ...explanation,
  see: 'docs/proofs.md, "The kinds of proof"',
}));

/** A code that is also one of a problem is explained as that. */
const PROOFS = PROOF_KINDS.filter(({ code }) => !ALL.some((problem) => problem.code === code));

/** Every code that the command explains. */
export const EXPLAINED_CODES: readonly string[] = [...ALL, ...PROOFS].map(({ code }) => code);

export const help: CommandHelp = {
  description:
    'Explain a problem (what it means, why it matters, how to fix it) or a kind of proof. Without a code, list every code on a line.',
  more: `
Examples:
  $ gq explain
  $ gq explain unknown-key
  $ gq explain out-of-range    a kind of proof`,
};

export function declare(command: Command, finish: (result: CommandResult) => void): void {
  command
    .argument('[code]', 'the code of a problem or a kind of proof, as reports name it')
    .addOption(formatOption('pretty', 'json'))
    .action((code: string | undefined, { format }: { format: 'pretty' | 'json' }) => finish(explain(code, format)));
}

function explain(code: string | undefined, format: 'pretty' | 'json'): CommandResult {
  const colors = colorsFor(process.stdout);
  if (code === undefined) {
    return {
      output:
        format === 'json'
          ? `${JSON.stringify({ version: 1, codes: [...ALL], proofs: [...PROOF_KINDS] } satisfies ExplainReport)}\n`
          : listCodes(ALL, PROOFS, colors),
      exitCode: 0,
    };
  }
  const proof = PROOFS.find((entry) => entry.code === code);
  if (proof !== undefined)
    return {
      output:
        format === 'json' ? `${JSON.stringify({ version: 1, ...proof } satisfies ExplainReport)}\n` : explainProof(proof, colors),
      exitCode: 0,
    };
  const found = ALL.find((entry) => entry.code === code);
  if (found === undefined) {
    throw new Failure(
      `no problem or kind of proof has the code ${JSON.stringify(code)}${didYouMean(code, EXPLAINED_CODES)}; gq explain lists all codes`,
    );
  }
  return {
    output:
      format === 'json' ? `${JSON.stringify({ version: 1, ...found } satisfies ExplainReport)}\n` : explainPretty(found, colors),
    exitCode: 0,
  };
}
