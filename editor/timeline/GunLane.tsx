import { type KeyboardEvent, memo, useRef } from 'react';
import { useStore } from 'zustand';
import type { Hold } from '../../schema/index.ts';
import { useLevel } from '../core/context/index.ts';
import { moveHold, stretchHold } from '../core/document/index.ts';
import { type Grip, holdsInWords, isCut, isMissed, type Reached } from './holds.ts';
import { type Scale, toX } from './scale.ts';
import { useHoldDrag } from './use-hold-drag.ts';

const NONE: readonly number[] = [];

interface GunLaneProps {
  /** The name of the run whose holds are shown. */
  readonly run: string;
  readonly holds: readonly Hold[];
  readonly reached: Reached;
  readonly scale: Scale;
  /** Called when a drag begins and ends; the scale must not change in between. */
  readonly onDragging: (isDragging: boolean) => void;
  /** How far each press and release may move alone; null if unknown or outdated. */
  readonly slack: readonly EdgeRoom[] | null;
}

/**
 * The holds of a run as bars: drag to move, drag an end to stretch, double-click to split, drag on the empty lane to add one.
 */
export const GunLane = memo(function GunLane({ run, holds, reached, scale, slack, onDragging }: GunLaneProps) {
  const { document, selection } = useLevel();
  const selected = useStore(selection.store, (state) => (state.run === run ? state.holds : NONE));
  const lane = useRef<HTMLDivElement>(null);
  const drag = useHoldDrag({ lane, run, holds, scale, selected, onDragging });

  const onKey = (event: KeyboardEvent<HTMLElement>, part: Grip['part'], index: number) => {
    if (event.key === 'Escape' && drag.isDragging()) {
      event.stopPropagation();
      drag.cancel();
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

  return (
    <div
      ref={lane}
      className="lane"
      role="application"
      aria-label={`Gun of the run ${run}: ${holdsInWords(holds, reached)}`}
      {...drag.listeners}
    >
      {reached.isBroken && <div className="lane__after" style={{ left: toX(scale, reached.until) }} />}
      {holds.map((hold, index) => (
        <HoldBar
          // Holds have no ids: the index identifies them.
          // biome-ignore lint/suspicious/noArrayIndexKey: see above
          key={index}
          hold={hold}
          index={index}
          reached={reached}
          scale={scale}
          isSelected={selected.includes(index)}
          slack={slack === null ? null : [slack[2 * index], slack[2 * index + 1]]}
          onKey={onKey}
        />
      ))}
    </div>
  );
});

/** How far a press or release may move alone, in ticks. */
interface EdgeRoom {
  readonly earlier: number;
  readonly later: number;
}

interface HoldBarProps {
  readonly hold: Hold;
  readonly index: number;
  readonly reached: Reached;
  readonly scale: Scale;
  readonly isSelected: boolean;
  /** Slack of press and release; null while unknown. */
  readonly slack: readonly [EdgeRoom | undefined, EdgeRoom | undefined] | null;
  readonly onKey: (event: KeyboardEvent<HTMLElement>, part: Grip['part'], index: number) => void;
}

const seconds = (tick: number) => `${(tick / 60).toFixed(2)} s`;

/** One hold in the lane, with the slack of its ends. */
function HoldBar({ hold, index, reached, scale, isSelected, slack, onKey }: HoldBarProps) {
  const [press, release] = hold;
  const missed = isMissed(hold, reached);
  const cut = isCut(hold, reached);
  const state = `${missed ? ' hold--missed' : ''}${isSelected ? ' hold--selected' : ''}`;
  const gets = missed ? ', not reached' : cut ? `, reached until ${seconds(reached.until)}` : '';
  const edge = (part: 'press' | 'release', tick: number) => (
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
    <div>
      {slack?.map((side, k) =>
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
      <div className={`hold${state}`} style={{ left: toX(scale, press), width: Math.max(2, (release - press) * scale.zoom) }}>
        {cut && <div className="hold__cut" style={{ left: (reached.until - press) * scale.zoom }} />}
        <button
          type="button"
          className="hold__body"
          aria-label={`Hold ${index + 1}: tick ${press} to ${release}, ${seconds(press)} for ${seconds(release - press)}, ${release - press} ticks${gets}`}
          aria-pressed={isSelected}
          onKeyDown={(event) => onKey(event, 'body', index)}
        >
          {(release - press) * scale.zoom > 34 ? release - press : ''}
        </button>
        {edge('press', press)}
        {edge('release', release)}
      </div>
    </div>
  );
}
