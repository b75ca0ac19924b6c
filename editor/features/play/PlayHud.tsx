import { RotateCcw, Route, X } from 'lucide-react';
import { useStore } from 'zustand';
import { useEditor, useProof, useSession } from '../../core/context/index.ts';
import { RATE_NAMES, RATES } from '../../core/session/index.ts';
import { Button } from '../../core/ui/index.ts';
import { SpeedAndMinerals } from './SpeedAndMinerals.tsx';
import { useGamepad } from './use-gamepad.ts';
import type { Readout } from './use-playtest.ts';

interface PlayHudProps {
  readonly readout: Readout | null;
  /** How to hold the gun, in words. */
  readonly gun: string;
  readonly touch: boolean;
  readonly isOver: boolean;
  readonly onRestart: () => void;
  readonly onLeave: () => void;
  /** Focuses the element that receives the gun's input. */
  readonly toGun: () => void;
}

/** Time, speed and minerals during a playtest, and its controls. */
export function PlayHud({ readout, gun, touch, isOver, onRestart, onLeave, toGun }: PlayHudProps) {
  const { settings, session } = useEditor();
  const rate = useSession((state) => state.rate);
  const hasPad = useGamepad();
  const slower = RATES[RATES.indexOf(rate) - 1] ?? RATES[RATES.length - 1];
  const controls = hasPad
    ? 'gamepad: A: gun · Select: again · Start: edit'
    : touch
      ? `${gun}: gun`
      : `${gun} or Space: gun · R: again · Esc: edit`;
  const isRunShown = useStore(settings, ({ runInPlay }) => runInPlay);
  const hasRun = useProof(({ run }) => run.name !== null);
  return (
    <div className="play__hud">
      <div className="play__readout numbers" aria-hidden>
        <span>{((readout?.tick ?? 0) / 60).toFixed(2)} s</span>
        <SpeedAndMinerals speed={readout?.speed ?? 0} minerals={readout?.minerals ?? 0} />
        <span className="play__hint">{controls}</span>
      </div>
      <div className="play__tools">
        <Button
          hint={`Play at ${RATE_NAMES[slower]}`}
          shortcut="[ ]"
          aria-label={`Speed ${RATE_NAMES[rate]}`}
          onClick={() => {
            session.setState({ rate: slower });
            toGun();
          }}
        >
          {RATE_NAMES[rate]}
        </Button>
        {hasRun && (
          <Button
            hint="Show the run's path"
            shortcut="W"
            icon={<Route size={15} />}
            pressed={isRunShown}
            onClick={() => {
              settings.setState({ runInPlay: !isRunShown });
              toGun();
            }}
          />
        )}
        {/* for users without a keyboard */}
        {touch && !isOver && (
          <>
            <Button hint="Play again" icon={<RotateCcw size={15} />} onClick={onRestart} />
            <Button hint="Back to editing" icon={<X size={15} />} onClick={onLeave} />
          </>
        )}
      </div>
    </div>
  );
}
