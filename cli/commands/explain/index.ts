import process from 'node:process';
import type { Command } from 'commander';
import type { ExplainReport } from '../../../schema/index.ts';
import type { CommandHelp, CommandResult } from '../../command.ts';
import { EXPLAINED_CODES as ALL } from '../../explained-codes.ts';
import { formatOption } from '../../options/index.ts';
import { colorsFor, didYouMean, Failure } from '../../terminal/index.ts';
import { explainPretty, explainProof, listCodes, PROOF_KINDS } from './report.ts';

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
