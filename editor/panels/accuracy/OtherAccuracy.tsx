import { useProofAtRest } from '../../context/index.ts';
import type { LiveProof } from '../../proof/index.ts';
import { otherEndOf } from './other-accuracy.ts';

/** ms without a change before the comparison, which simulates two whole runs */
const REST = 300;

const compared = (proof: LiveProof) => otherEndOf(proof);

const px = (distance: number): string => (distance >= 0.05 ? distance.toFixed(1) : distance.toPrecision(1));

/** Whether another accuracy would give the same outcome for the shown run, in a few words. */
export function OtherAccuracy() {
  const other = useProofAtRest(compared, REST);
  if (other === null) return null;
  const { name, distance, isSame } = other;
  return (
    <span className={isSame ? undefined : 'tone--warn'}>
      {isSame ? `${name} would differ by ${px(distance)} px, same verdict` : `${name} would end differently`}
    </span>
  );
}
