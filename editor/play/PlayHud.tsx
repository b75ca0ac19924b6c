import { RotateCcw, Route, X } from 'lucide-react';
import { useStore } from 'zustand';
import { useEditor, useProof } from '../context/index.ts';
import { Button } from '../ui/index.ts';
import { SpeedAndMinerals } from './SpeedAndMinerals.tsx';
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
  const { settings } = useEditor();
  const isRunShown = useStore(settings, ({ runInPlay }) => runInPlay);
  const hasRun = useProof(({ run }) => run.name !== null);
  return (
    <div className="play__hud">
      <div className="play__readout numbers" aria-hidden>
        <span>{((readout?.tick ?? 0) / 60).toFixed(2)} s</span>
        <SpeedAndMinerals speed={readout?.speed ?? 0} minerals={readout?.minerals ?? 0} />
        <span className="play__hint">{touch ? `${gun}: gun` : `${gun} or Space: gun · R: again · Esc: edit`}</span>
      </div>
      <div className="play__tools">
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
