import { CircleCheck, CircleDotDashed, Clock, Skull, Unlink } from 'lucide-react';
import { type ComponentType, type ReactNode, useId } from 'react';
import type { Outcome } from '../../../engine/index.ts';
import { useEditor } from '../context/index.ts';
import type { Fact } from '../figures/index.ts';
import './parts.css';

interface SectionProps {
  readonly title: string;
  /** Beside the title: a count, a button. */
  readonly aside?: ReactNode;
  readonly children: ReactNode;
}

/** A titled part of a panel. */
export function Section({ title, aside, children }: SectionProps) {
  const id = useId();
  return (
    <section className="part" aria-labelledby={id}>
      <div className="part__head">
        <h3 id={id} className="part__title">
          {title}
        </h3>
        {aside}
      </div>
      {children}
    </section>
  );
}

/** A list of labelled values; those with a moment lead there. */
export function Facts({ facts }: { readonly facts: readonly Fact[] }) {
  const { session } = useEditor();
  return (
    <dl className="facts numbers">
      {facts.map(({ label, value, tick, tone }) => (
        <div key={label} className="facts__row">
          <dt>{label}</dt>
          <dd className={tone === undefined ? undefined : `tone--${tone}`}>
            {tick === undefined ? (
              value
            ) : (
              <button
                type="button"
                className="facts__moment"
                title="Show this moment"
                onClick={() => session.setState({ tick, isPlayingBack: false })}
              >
                {value}
              </button>
            )}
          </dd>
        </div>
      ))}
    </dl>
  );
}

interface SegmentsProps<T extends string> {
  readonly label: string;
  /** null: none is chosen, as the selected objects differ */
  readonly value: T | null;
  readonly options: readonly { readonly value: T; readonly title: string; readonly about?: string; readonly icon?: ReactNode }[];
  readonly disabled?: boolean;
  readonly onChange: (value: T) => void;
}

/** A choice of one among a few options, all visible. */
export function Segments<T extends string>({ label, value, options, disabled = false, onChange }: SegmentsProps<T>) {
  const name = useId();
  return (
    <fieldset className="segments" disabled={disabled}>
      <legend className="segments__label">{label}</legend>
      <div className="segments__row">
        {options.map((option) => (
          <label key={option.value} className="segments__one" title={option.about}>
            <input
              type="radio"
              name={name}
              value={option.value}
              checked={option.value === value}
              onChange={() => onChange(option.value)}
            />
            <span>
              {option.icon}
              {option.title}
            </span>
          </label>
        ))}
      </div>
    </fieldset>
  );
}

interface ProgressProps {
  readonly label: string;
  readonly isRunning: boolean;
  /** 0 to 1; absent if the duration is unknown. */
  readonly share?: number;
}

/** Says what went wrong, and what to do. */
export const Trouble = ({ children }: { readonly children: ReactNode }) => (
  <p className="tone--bad" role="alert">
    {children}
  </p>
);

/** A progress bar. It keeps its space when it is over, so that controls below do not move under the pointer. */
export function Progress({ label, isRunning, share }: ProgressProps) {
  // Without a value it would keep animating, unseen.
  return (
    <progress className={isRunning ? 'progress' : 'progress progress--over'} aria-label={label} value={isRunning ? share : 1} />
  );
}

const SIGNS: Readonly<Record<Outcome, { Icon: ComponentType<{ size: number }>; word: string; look: string }>> = {
  completed: { Icon: CircleCheck, word: 'completes', look: 'good' },
  collided: { Icon: Skull, word: 'collides', look: 'bad' },
  lost: { Icon: Unlink, word: 'is lost', look: 'bad' },
  timeout: { Icon: Clock, word: 'times out', look: 'warn' },
};

/** The end of a run in one word or two. */
export const outcomeWord = (outcome: Outcome | null): string => (outcome === null ? 'not simulated yet' : SIGNS[outcome].word);

/** The end of a run as an icon beside the word. */
export function OutcomeSign({ outcome }: { outcome: Outcome | null }) {
  if (outcome === null) {
    return (
      <span className="runs__sign">
        <CircleDotDashed size={15} aria-hidden />
      </span>
    );
  }
  const { Icon, look } = SIGNS[outcome];
  return (
    <span className={`runs__sign runs__sign--${look}`}>
      <Icon size={15} aria-hidden />
    </span>
  );
}
