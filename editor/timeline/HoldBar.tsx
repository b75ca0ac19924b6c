import type { KeyboardEvent } from 'react';
import type { Hold } from '../../schema/index.ts';
import type { Grip } from './grip.ts';
import { isCut, isMissed, type Reached } from './reached.ts';
import { type Scale, toX } from './scale.ts';

/** How far a press or release may move alone, in ticks. */
export interface EdgeRoom {
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
export function HoldBar({ hold, index, reached, scale, isSelected, slack, onKey }: HoldBarProps) {
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
