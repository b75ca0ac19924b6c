import { Tooltip } from 'radix-ui';
import type { ReactNode } from 'react';

interface HintProps {
  readonly text: string;
  readonly shortcut?: string;
  /** Where it stands if there is room; above if absent. In a list, what stands above is the next thing to press. */
  readonly side?: 'left' | undefined;
  readonly children: ReactNode;
}

/** A tooltip for the one element inside. */
export function Hint({ text, shortcut, side, children }: HintProps) {
  return (
    <Tooltip.Root>
      <Tooltip.Trigger asChild>{children}</Tooltip.Trigger>
      <Tooltip.Portal>
        <Tooltip.Content className="tooltip" side={side} sideOffset={6} collisionPadding={8}>
          {text}
          {shortcut !== undefined && <kbd>{shortcut}</kbd>}
        </Tooltip.Content>
      </Tooltip.Portal>
    </Tooltip.Root>
  );
}
