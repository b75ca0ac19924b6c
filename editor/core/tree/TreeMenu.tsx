import { ContextMenu } from 'radix-ui';
import { Fragment, type ReactElement } from 'react';
import type { MenuEntry } from './tree-rows.ts';

/** The context menu of the active row, opened anywhere in the tree. */
export function TreeMenu({ entries, children }: { readonly entries: readonly MenuEntry[]; readonly children: ReactElement }) {
  return (
    <ContextMenu.Root>
      <ContextMenu.Trigger asChild>{children}</ContextMenu.Trigger>
      <ContextMenu.Portal>
        <ContextMenu.Content className="menu" collisionPadding={8}>
          {entries.map((entry, index) =>
            entry === null ? (
              // biome-ignore lint/suspicious/noArrayIndexKey: lines have no name, and the menu is rebuilt each time
              <ContextMenu.Separator key={index} className="menu__line" />
            ) : (
              <Fragment key={entry.title}>
                <ContextMenu.Item className="menu__item" disabled={entry.disabled} onSelect={entry.run}>
                  {entry.title}
                  {entry.keys !== undefined && <kbd>{entry.keys}</kbd>}
                </ContextMenu.Item>
              </Fragment>
            ),
          )}
        </ContextMenu.Content>
      </ContextMenu.Portal>
    </ContextMenu.Root>
  );
}
