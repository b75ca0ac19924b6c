import { Tooltip } from 'radix-ui';
import type { ReactNode } from 'react';

interface HintProps {
  readonly text: string;
  readonly shortcut?: string;
  readonly children: ReactNode;
}

/** A tooltip for the one element inside. */
export function Hint({ text, shortcut, children }: HintProps) {
  return (
    <Tooltip.Root>
      <Tooltip.Trigger asChild>{children}</Tooltip.Trigger>
      <Tooltip.Portal>
        <Tooltip.Content className="tooltip" sideOffset={6} collisionPadding={8}>
          {text}
          {shortcut !== undefined && <kbd>{shortcut}</kbd>}
        </Tooltip.Content>
      </Tooltip.Portal>
    </Tooltip.Root>
  );
}
