import { useLevel } from '../../core/context/index.ts';
import type { Readout } from './use-playtest.ts';

/** Her speed, and the minerals that she has. */
export function SpeedAndMinerals({ speed, minerals }: Pick<Readout, 'speed' | 'minerals'>) {
  const { minerals: all } = useLevel().proof.proof().level;
  return (
    <>
      <span>{Math.round(speed)} px/s</span>
      {all.length > 0 && (
        <span>
          minerals {minerals}/{all.length}
        </span>
      )}
    </>
  );
}
