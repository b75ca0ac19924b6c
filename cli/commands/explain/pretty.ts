import type { CodeExplanation } from '../../../schema/index.ts';
import type { Colors } from '../../io/index.ts';
import { alignColumns } from '../../report-parts/index.ts';
import type { ProofExplanation } from './proofs.ts';

const WIDTH = 100;

/** The explanation of one code for people. */
export function explainPretty({ code, severity, title, why, fix, example }: CodeExplanation, colors: Colors): string {
  const paint = severity === 'error' ? colors.red : colors.yellow;
  let text = `${colors.bold(code)} (${paint(severity)}): ${title}\n\n${wrap(why)}\n\n${colors.bold('How to fix it')}\n${wrap(fix)}\n`;
  if (example !== undefined) text += `\n${colors.bold('Example')}\n${example.replace(/^/gm, '  ')}\n`;
  return text;
}

/** One kind of proof in full, for a person. */
export function explainProof({ code, title, why, fix, see }: ProofExplanation, colors: Colors): string {
  return `${colors.bold(code)} (kind of proof): ${title}\n\n${wrap(why)}\n\n${colors.bold('What to do')}\n${wrap(fix)}\n\nThe full argument: ${see}\n`;
}

/** Every code and every kind of proof on a line. */
export function listCodes(codes: readonly CodeExplanation[], proofs: readonly ProofExplanation[], colors: Colors): string {
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
