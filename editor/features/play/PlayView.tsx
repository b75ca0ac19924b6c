import { Check, Plus, RotateCcw, Route, X } from 'lucide-react';
import { type RefObject, useCallback, useEffect, useRef, useState } from 'react';
import { useStore } from 'zustand';
import { outcomeAsPredicate, type RunEnd } from '../../../check/words/index.ts';
import { useEditor, useLevel, useProof, useSession, useTouch } from '../../core/context/index.ts';
import { keepAsRun, makeProof } from '../../core/levels/index.ts';
import { RATE_NAMES, RATES } from '../../core/session/index.ts';
import { Button } from '../../core/ui/index.ts';
import { type Readout, usePlaytest } from './use-playtest.ts';

/** The playtest over the canvas: it takes the gun's input and plays in fixed ticks. */
export function PlayView() {
  const editor = useEditor();
  const level = useLevel();
  const host = useRef<HTMLDivElement>(null);
  const { readout, attempt, start } = usePlaytest(host);
  const toGun = useCallback(() => host.current?.focus({ preventScroll: true }), []);
  const leave = useCallback(() => editor.session.setState({ mode: 'edit' }), [editor]);
  const won = attempt?.end?.outcome === 'completed';
  const promote = useCallback(() => {
    if (attempt === null) return;
    (won ? makeProof : keepAsRun)({ editor, level }, attempt);
    leave();
  }, [editor, level, attempt, won, leave]);

  useEffect(
    () =>
      editor.commands.register([
        { id: 'play.stop', title: 'Back to editing', group: 'Play', mode: 'play', keys: ['Escape'], pad: 'Start', run: leave },
        { id: 'play.restart', title: 'Play again', group: 'Play', mode: 'play', keys: ['r'], pad: 'Select', run: start },
        {
          id: 'play.promote',
          title: 'Keep this attempt as a run',
          group: 'Play',
          mode: 'play',
          keys: ['Enter'],
          needs: () => (attempt === null ? 'the attempt has not ended' : null),
          run: promote,
        },
      ]),
    [editor, leave, start, promote, attempt],
  );

  const touch = useTouch();
  const end = attempt?.end ?? null;
  const gun = touch ? 'hold a finger on the screen' : 'hold the mouse button';
  return (
    <div ref={host} className="play" tabIndex={-1} role="application" aria-label={`Playtest: ${gun} to hold the gun`}>
      <PlayHud readout={readout} gun={gun} touch={touch} isOver={end !== null} onRestart={start} onLeave={leave} toGun={toGun} />
      {end !== null && <PlayEnd end={end} onRestart={start} onKeep={promote} onLeave={leave} />}
    </div>
  );
}

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
function PlayHud({ readout, gun, touch, isOver, onRestart, onLeave, toGun }: PlayHudProps) {
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

interface PlayEndProps {
  readonly end: RunEnd;
  readonly onRestart: () => void;
  /** Adds what was played to the level. */
  readonly onKeep: () => void;
  readonly onLeave: () => void;
}

/** How a playtest ended, and what to do with it. */
function PlayEnd({ end, onRestart, onKeep, onLeave }: PlayEndProps) {
  const { range } = useLevel().proof.proof().level;
  const won = end.outcome === 'completed';
  const panel = useRef<HTMLDivElement>(null);
  usePadChoice(panel);
  return (
    <div ref={panel} className={`play__end play__end--${won ? 'won' : 'lost'}`} role="status">
      <strong>{won ? 'Level completed' : 'Not completed'}</strong>
      <span>She {outcomeAsPredicate(end, range)}.</span>
      <span className="play__actions">
        <Button
          hint="Play again"
          shortcut="R"
          look={won ? 'outlined' : 'main'}
          icon={<RotateCcw size={15} />}
          onClick={onRestart}
        >
          Again
        </Button>
        <Button
          hint={
            won ? 'Keep this attempt in the level as the run that completes it' : 'Keep this attempt in the level as its last run'
          }
          shortcut="Enter"
          look={won ? 'main' : 'outlined'}
          icon={won ? <Check size={15} /> : <Plus size={15} />}
          onClick={onKeep}
        >
          Keep as a run
        </Button>
        <Button hint="Back to editing" shortcut="Esc" look="outlined" icon={<X size={15} />} onClick={onLeave}>
          Edit
        </Button>
      </span>
    </div>
  );
}

/** Whether a gamepad has been used since this component was shown; browsers hide gamepads until then. */
function useGamepad(): boolean {
  const [count, setCount] = useState(0);
  useEffect(() => {
    const look = () => setCount(navigator.getGamepads?.().filter((pad) => pad !== null).length ?? 0);
    look();
    window.addEventListener('gamepadconnected', look);
    window.addEventListener('gamepaddisconnected', look);
    return () => {
      window.removeEventListener('gamepadconnected', look);
      window.removeEventListener('gamepaddisconnected', look);
    };
  }, []);
  return count > 0;
}

/** While an element is shown, a gamepad moves the focus among its buttons with the directions and presses one with A. */
function usePadChoice(element: RefObject<HTMLElement | null>): void {
  const { commands } = useEditor();
  useEffect(() => {
    const buttons = () => [...(element.current?.querySelectorAll('button') ?? [])];
    const move = (by: number) => {
      const all = buttons();
      const now = all.indexOf(document.activeElement as HTMLButtonElement);
      all[now < 0 ? 0 : (now + by + all.length) % all.length]?.focus();
    };
    const press = () =>
      buttons()
        .find((button) => button === document.activeElement)
        ?.click();
    const pad = { group: 'Play', mode: 'play', hidden: true } as const;
    return commands.register([
      { ...pad, id: 'play.choose-previous', title: 'Previous button', pad: 'Left', run: () => move(-1) },
      { ...pad, id: 'play.choose-next', title: 'Next button', pad: 'Right', run: () => move(1) },
      { ...pad, id: 'play.choose', title: 'Press the button', pad: 'A', run: press },
    ]);
  }, [commands, element]);
}
