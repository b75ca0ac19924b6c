export { areAll, type OrderActions, orderActions } from './order-actions.ts';
export { orderCommands } from './order-commands.ts';
export { groupRowKey } from './row-keys.ts';
