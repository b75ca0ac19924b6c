import { type KeyboardEvent, memo, type PointerEvent, useRef } from 'react';
import { useStore } from 'zustand';
import type { Hold } from '../../schema/index.ts';
import { useEditor, useLevel } from '../context/index.ts';
import { addHold, type Gesture, moveHold, splitHold, stretchHold } from '../document/index.ts';
import { type Grip, gripAt } from './grip.ts';
import { holdsInWords, isCut, isMissed, type Reached } from './reached.ts';
import { type Scale, toTick, toX } from './scale.ts';

const NONE: readonly number[] = [];
const NO_HOLD: readonly [number, number] = [0, 0];

interface GunLaneProps {
  /** Name of the run whose holds are shown. */
  readonly run: string;
  readonly holds: readonly Hold[];
  readonly reached: Reached;
  readonly scale: Scale;
  /** Told when a drag begins and ends: the scale must stay as it is meanwhile. */
  readonly onDragging: (isDragging: boolean) => void;
  /** How far each press and release may move alone, ticks; null while unknown or no longer true. */
  readonly slack: readonly { readonly earlier: number; readonly later: number }[] | null;
}

type Part = Grip['part'];

interface Drag {
  readonly part: Part | 'new';
  readonly index: number;
  /** What the hold was like when the drag began: the gesture starts from there each time. */
  readonly hold: Hold;
  readonly x: number;
  readonly tick: number;
  readonly gesture: Gesture;
  moved: boolean;
}

const LABELS = { body: 'Move hold', press: 'Move press', release: 'Move release', new: 'Add hold' } as const;

/** px that a press may move and still be a click */
const SLOP = 3;

const seconds = (tick: number) => `${(tick / 60).toFixed(2)} s`;

/** When the gun is held, as bars: drag to move, drag an end to stretch, double-click to split, drag on empty lane for a new one. */
export const GunLane = memo(function GunLane({ run, holds, reached, scale, slack, onDragging }: GunLaneProps) {
  const { session, notices } = useEditor();
  const { document, selection } = useLevel();
  const selected = useStore(selection.store, (state) => (state.run === run ? state.holds : NONE));
  const lane = useRef<HTMLDivElement>(null);
  const drag = useRef<Drag | null>(null);

  const xOf = (event: { clientX: number }) => event.clientX - (lane.current?.getBoundingClientRect().left ?? 0);
  const begin = (event: PointerEvent<HTMLElement>) => {
    if (event.button !== 0) return;
    event.currentTarget.setPointerCapture(event.pointerId);
    onDragging(true);
    const x = xOf(event);
    // where it is says what it takes: targets for fingers lie over one another
    const grip = gripAt(holds, scale, x, event.pointerType === 'touch' ? 'coarse' : 'fine');
    const { part, index } = grip ?? ({ part: 'new', index: -1 } as const);
    drag.current = {
      part,
      index,
      hold: holds[index] ?? NO_HOLD,
      x,
      tick: toTick(scale, x),
      gesture: document.begin(LABELS[part]),
      moved: false,
    };
    if (grip === null) return;
    const others = event.shiftKey ? selected : NONE;
    selection.selectHolds(run, others.includes(index) ? others.filter((hold) => hold !== index) : [...others, index]);
  };
  const onMove = (event: PointerEvent<HTMLElement>) => {
    const now = drag.current;
    if (now === null) return;
    const x = xOf(event);
    if (!now.moved && Math.abs(x - now.x) < SLOP) return;
    now.moved = true;
    const by = Math.round((x - now.x) / scale.zoom);
    const ripple = { ripple: event.altKey };
    const recipe = () => {
      if (now.part === 'new') return addHold(run, Math.max(0, Math.floor(now.tick)), Math.max(0, Math.ceil(now.tick + by)));
      if (now.part === 'body') return moveHold(run, now.index, by, ripple);
      const edge = now.part === 'press' ? now.hold[0] : now.hold[1];
      return stretchHold(run, now.index, now.part, edge + by, ripple);
    };
    const result = now.gesture.set(recipe());
    if (!result.ok) notices.show('warning', result.refusal.message, { topic: 'refused' });
  };
  const onEnd = () => {
    const now = drag.current;
    drag.current = null;
    onDragging(false);
    if (now === null) return;
    if (now.moved) now.gesture.commit();
    else {
      now.gesture.cancel();
      if (now.part === 'new') {
        selection.clear();
        session.setState({ tick: Math.max(0, Math.round(now.tick)) });
      }
    }
  };
  const cancel = () => {
    drag.current?.gesture.cancel();
    drag.current = null;
    onDragging(false);
  };
  const split = (event: { clientX: number }) => {
    const tick = toTick(scale, xOf(event));
    const index = holds.findIndex(([press, release]) => press < tick && tick < release);
    if (index >= 0) document.change('Split hold', splitHold(run, index, tick));
  };
  const onKey = (event: KeyboardEvent<HTMLElement>, part: Part, index: number) => {
    if (event.key === 'Escape' && drag.current !== null) {
      event.stopPropagation();
      cancel();
      return;
    }
    if (event.key !== 'ArrowLeft' && event.key !== 'ArrowRight') return;
    event.preventDefault();
    event.stopPropagation();
    const by = (event.key === 'ArrowLeft' ? -1 : 1) * (event.shiftKey ? 10 : 1);
    const ripple = { ripple: event.altKey };
    const hold = holds[index];
    const recipe =
      part === 'body'
        ? moveHold(run, index, by, ripple)
        : stretchHold(run, index, part, (part === 'press' ? hold[0] : hold[1]) + by, ripple);
    document.change('Move hold', recipe, { gesture: `hold ${run} ${part} ${index}` });
  };

  const edge = (part: 'press' | 'release', index: number, tick: number) => (
    <div
      className={`hold__edge hold__edge--${part}`}
      role="slider"
      tabIndex={0}
      aria-label={`${part === 'press' ? 'Press' : 'Release'} of hold ${index + 1}`}
      aria-valuenow={tick}
      aria-valuemin={0}
      aria-valuemax={3600}
      aria-valuetext={`tick ${tick}, ${seconds(tick)}`}
      onKeyDown={(event) => onKey(event, part, index)}
    />
  );
  return (
    <div
      ref={lane}
      className="lane"
      role="application"
      aria-label={`Gun of the run ${run}: ${holdsInWords(holds, reached)}`}
      onPointerDown={begin}
      onPointerMove={onMove}
      onPointerUp={onEnd}
      onPointerCancel={cancel}
      onDoubleClick={split}
    >
      {reached.isBroken && <div className="lane__after" style={{ left: toX(scale, reached.until) }} />}
      {holds.map((hold, index) => {
        const [press, release] = hold;
        const soft = slack === null ? null : ([slack[2 * index], slack[2 * index + 1]] as const);
        const missed = isMissed(hold, reached);
        const cut = isCut(hold, reached);
        const state = `${missed ? ' hold--missed' : ''}${selected.includes(index) ? ' hold--selected' : ''}`;
        const gets = missed ? ', not reached' : cut ? `, reached until ${seconds(reached.until)}` : '';
        return (
          // holds have no names of their own: their place in the order is what they are
          // biome-ignore lint/suspicious/noArrayIndexKey: see above
          <div key={index}>
            {soft?.map((side, k) =>
              side === undefined ? null : (
                <div
                  key={k === 0 ? 'press' : 'release'}
                  className="hold__slack"
                  style={{
                    left: toX(scale, (k === 0 ? press : release) - side.earlier),
                    width: (side.earlier + side.later) * scale.zoom,
                  }}
                />
              ),
            )}
            <div
              className={`hold${state}`}
              style={{ left: toX(scale, press), width: Math.max(2, (release - press) * scale.zoom) }}
            >
              {cut && <div className="hold__cut" style={{ left: (reached.until - press) * scale.zoom }} />}
              <button
                type="button"
                className="hold__body"
                aria-label={`Hold ${index + 1}: tick ${press} to ${release}, ${seconds(press)} for ${seconds(release - press)}${gets}`}
                aria-pressed={selected.includes(index)}
                onKeyDown={(event) => onKey(event, 'body', index)}
              >
                {(release - press) * scale.zoom > 34 ? release - press : ''}
              </button>
              {edge('press', index, press)}
              {edge('release', index, release)}
            </div>
          </div>
        );
      })}
    </div>
  );
});
