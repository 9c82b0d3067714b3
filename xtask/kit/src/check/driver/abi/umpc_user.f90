! F is the distance of node m from the line, and A its derivatives by the displacements. The nodes of the terms are
! m, node 1 and node n, {dim} times each, with the degrees of freedom 1 to {dim}, which JDOF may change. All nodes are at
! X + U.{second}
---
    subroutine ask()
        integer, parameter :: dim = {dim}, n = 3 * dim
        real(dp) :: x0(3, n), u(3, n), f, a(n), force
        integer :: jdof(n), iit, idiscon, equation, term
        ! Behind which input the position of a term's node stands.
        integer, parameter :: behind(n) = [(2 * dim, term=1, dim), (0, term=1, dim), (dim, term=1, dim)]
        external :: {externals}
        do equation = 1, outputs
            x0 = 0
            u = 0
            f = 0
            a = 0
            do term = 1, n
                x0(1:dim, term) = x(behind(term) + 1:behind(term) + dim) / 2
                u(1:dim, term) = x(behind(term) + 1:behind(term) + dim) - x0(1:dim, term)
                jdof(term) = 1 + mod(term - 1, dim)
            end do
            force = 0
            iit = 1
            idiscon = 0
            {calls}
            if (any(jdof < 1 .or. jdof > dim)) error stop 'JDOF is no degree of freedom of the line'
            y(equation) = f
            jacobian(equation, :) = 0
            do term = 1, n
                column = behind(term) + jdof(term)
                jacobian(equation, column) = jacobian(equation, column) + a(term)
            end do
        end do
    end subroutine ask
