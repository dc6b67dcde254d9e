"""What each route answers, as models: the server checks them, the console's TypeScript is made from them."""
