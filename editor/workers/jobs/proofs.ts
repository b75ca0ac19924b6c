import { proveImpossible, proveMineralsUnreachable, verifyProof } from '../../../solver/index.ts';
import type { Results } from '../protocol.ts';
import type { Start } from '../work.ts';

/** Minerals that are asked about: each takes a moment. */
const MOST_MINERALS = 20;

/** Proves what can't be reached. Nothing is given that the separate checker doesn't confirm. */
export const proofs: Start<'proofs'> = function* ({ level, accuracy }) {
  const proof = proveImpossible(level, { accuracy });
  const impossible = proof !== null && verifyProof(level, proof).ok ? proof : null;
  const minerals: { index: number; proof: Results['proofs']['minerals'][number]['proof'] }[] = [];
  yield { impossible, minerals };
  for (const index of [...level.minerals.keys()].slice(0, MOST_MINERALS)) {
    // minerals are in nobody's way: without the others the level is the same
    const only = { ...level, minerals: [level.minerals[index]] };
    const [found] = proveMineralsUnreachable(only, { accuracy });
    if (found !== undefined && verifyProof(only, found).ok) {
      minerals.push({
        index,
        proof: {
          ...found,
          about: { kind: 'mineral', index },
          reason: found.reason.replaceAll('minerals[0]', `minerals[${index}]`),
        },
      });
    }
    yield { impossible, minerals: [...minerals] };
  }
  return { impossible, minerals };
};
