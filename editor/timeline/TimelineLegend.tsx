import { CircleQuestionMark, X } from 'lucide-react';
import { Popover } from 'radix-ui';
import type { ReactNode } from 'react';
import { useTouch } from '../context/index.ts';
import { NEAR } from '../proof/index.ts';
import { Button } from '../ui/index.ts';

interface TimelineLegendProps {
  readonly isOpen: boolean;
  readonly onOpen: (isOpen: boolean) => void;
}

const mark = (text: string): ReactNode => <span className="legend__mark">{text}</span>;
const look = (name: string): ReactNode => <span className={`legend__look legend__look--${name}`} />;

const ENTRIES: readonly (readonly [sign: ReactNode, words: string])[] = [
  [look('hold'), 'The gun is held. The number is how long, in ticks of 1/60 s.'],
  [look('slack'), 'Slack: so far this press or this release alone may slip, and the run still completes the level.'],
  [look('missed'), 'Not reached: the run ends before this hold, or while it lasts.'],
  [look('after'), 'After the end of a run that breaks.'],
  [mark('A2'), 'The gun takes asteroid 2.'],
  [mark('◆1'), 'Mineral 1 is taken.'],
  [mark('R1 /R1'), 'She enters repulsor 1, and leaves it.'],
  [mark('E1! E1z'), 'Alien 1 wakes, and falls asleep.'],
  [mark('✺'), 'Two aliens explode.'],
  [mark('● ✕'), 'She reaches the black hole; she collides or is lost.'],
  [look('speed'), 'Her speed.'],
  [look('gap'), 'How far she is from the nearest thing that kills.'],
  [look('near'), `A graze: she passes such a thing by less than ${NEAR} px.`],
];

/** What bars, hatches, marks and lines of the timeline mean, and what can be done with a hold: for every pointer, and in words. */
export function TimelineLegend({ isOpen, onOpen }: TimelineLegendProps) {
  const touch = useTouch();
  return (
    <Popover.Root open={isOpen} onOpenChange={onOpen}>
      <Popover.Trigger asChild>
        <Button hint="What the timeline shows" icon={<CircleQuestionMark size={15} />} />
      </Popover.Trigger>
      <Popover.Portal>
        <Popover.Content
          className="legend"
          side="top"
          sideOffset={6}
          collisionPadding={8}
          aria-label="What the timeline shows"
          // on its first button the focus would open a tooltip, and Esc would close that instead
          onOpenAutoFocus={(event) => {
            event.preventDefault();
            if (event.target instanceof HTMLElement) event.target.focus();
          }}
        >
          <div className="legend__head">
            <h2 className="legend__title">What the timeline shows</h2>
            <Popover.Close asChild>
              <Button hint="Close" icon={<X size={15} />} />
            </Popover.Close>
          </div>
          <ul className="legend__list">
            {ENTRIES.map(([sign, words]) => (
              <li key={words} className="legend__one">
                <span className="legend__sign" aria-hidden>
                  {sign}
                </span>
                <span>{words}</span>
              </li>
            ))}
          </ul>
          <p className="legend__how">
            Drag the middle of a hold to move it, one of its ends to stretch it, the empty lane to add one.
            {touch ? ' Tap a hold twice to split it.' : ' With Alt all that follows comes along. A double-click splits a hold.'}
          </p>
        </Popover.Content>
      </Popover.Portal>
    </Popover.Root>
  );
}
